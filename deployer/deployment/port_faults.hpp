// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What can be wrong with the ports of a connection, whether manifests or the components themselves say which there are.
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

/// DEP041: `first` gives the connection its type, `other` has another one.
void reportOtherType(const std::string& connection, const ConnectedPort& first, const ConnectedPort& other,
                     diag::Sink& sink);

/// DEP042: an error if there is no output port among all ports of a connection, a warning if there is no input port.
void checkDirections(const std::string& connection, const std::vector<ConnectedPort>& ports, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
