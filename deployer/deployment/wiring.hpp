// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_WIRING_HPP
#define OROFORGE_DEPLOYMENT_WIRING_HPP

#include "session.hpp"

namespace OCL::deploy {

/** The deployer's operations that connect components: peers, ports, streams, services, operations. They report why they
    return false. Ports and operations are given by paths, `component[.service…].port`. */
class Wiring {
public:
    explicit Wiring(Session& session) : session_(session) {}

    bool connectPeers(const std::string& one, const std::string& two);
    /** By its own name if `alias` is empty. */
    bool addPeer(const std::string& from, const std::string& to, const std::string& alias = {});
    bool connectPorts(const std::string& one, const std::string& two);
    bool connect(const std::string& portOne, const std::string& portTwo, const RTT::ConnPolicy& policy);
    bool stream(const std::string& port, const RTT::ConnPolicy& policy);
    bool connectServices(const std::string& one, const std::string& two);
    /** An operation that a component requires to one that another provides. In connect_operations.cpp. */
    bool connectOperations(const std::string& requested, const std::string& provided);

private:
    Session& session_;
};

}  // namespace OCL::deploy

#endif
