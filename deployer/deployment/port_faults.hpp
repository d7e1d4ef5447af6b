// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reports faults of the ports of a connection, which are known from manifests or from the components themselves.
#ifndef OROFORGE_DEPLOYER_DEPLOYMENT_PORT_FAULTS_HPP
#define OROFORGE_DEPLOYER_DEPLOYMENT_PORT_FAULTS_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>

#include "plan.hpp"

namespace OCL::deploy {

struct ConnectedPort {
    diag::Location where;
    std::string name;  ///< "component.port"
    std::string type;
    bool isOutput;
};

/// DEP040; `known` are the ports that the component has.
diag::Diagnostic& reportUnknownPort(const std::string& component, const Text& port,
                                    const std::vector<std::string>& known, diag::Sink& sink);

/// DEP041: `other` has another type than `first`, which determines the type of the connection.
void reportOtherType(const std::string& connection, const ConnectedPort& first, const ConnectedPort& other,
                     diag::Sink& sink);

/// DEP042: an error if there is no output port among all ports of a connection, a warning if there is no input port.
void checkDirections(const std::string& connection, const std::vector<ConnectedPort>& ports, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
