// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "summary.hpp"

#include "session.hpp"

#include <set>

namespace OCL::deploy {
namespace {

std::string counted(std::size_t number, const std::string& what) {
    return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

}  // namespace

std::string summaryOf(const Session& session) {
    std::set<std::string> components, connections;
    for (const Plan& plan : session.planned)
        for (const ComponentPlan& component : plan.components) {
            if (!session.isDeployer(component.name.value)) components.insert(component.name.value);
            for (const PortPlan& port : component.ports) connections.insert(port.connection.value);
        }
    return counted(components.size(), "component") + ", " + counted(connections.size(), "connection");
}

}  // namespace OCL::deploy
