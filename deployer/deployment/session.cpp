// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "session.hpp"

#include <rtt/TaskContext.hpp>

namespace OCL::deploy {

bool Session::isDeployer(const std::string& name) const { return name == "this" || name == deployer->getName(); }

RTT::TaskContext* Session::component(const std::string& name) const {
    return isDeployer(name) ? deployer : deployer->getPeer(name);
}

ComponentRecord& Session::recordOf(RTT::TaskContext& component) {
    if (ComponentRecord* known = records.find(&component)) return *known;
    return records.add(component.getName(), &component);
}

std::vector<std::string> Session::componentNames() const {
    std::vector<std::string> names = deployer->getPeerList();
    names.push_back(deployer->getName());
    return names;
}

}  // namespace OCL::deploy
