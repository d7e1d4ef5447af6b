// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "stand_ins.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>

namespace OCL::schedule {
namespace {

/** Adds the port to the service that the path names, which is made. The port has the last part as its name. */
void addAt(RTT::TaskContext& component, const std::string& path, RTT::base::OutputPortInterface& port) {
    RTT::Service::shared_ptr service = component.provides();
    std::size_t begin = 0;
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', begin)) {
        service = service->provides(path.substr(begin, dot - begin));
        begin = dot + 1;
    }
    service->addPort(path.substr(begin), port);
}

}  // namespace

StandIns::StandIns(replay::Player& player) : player_(player) {
    for (const replay::Topic& topic : player.topics())
        if (!topic.component.empty()) topics_[topic.component].emplace(topic.port, topic.topic);
}

bool StandIns::hasComponent(const std::string& component) const { return topics_.count(component) != 0; }

bool StandIns::hasPort(const std::string& component, const std::string& port) const {
    const auto known = topics_.find(component);
    return known != topics_.end() && known->second.count(port) != 0;
}

std::vector<std::string> StandIns::portsOf(const std::string& component) const {
    std::vector<std::string> names;
    if (const auto known = topics_.find(component); known != topics_.end())
        for (const auto& port : known->second) names.push_back(port.first);
    return names;
}

void StandIns::addPorts(RTT::TaskContext& component, std::map<std::string, std::string>& problems) {
    const auto known = topics_.find(component.getName());
    if (known == topics_.end()) return;
    for (const auto& [port, topic] : known->second) {
        std::string problem;
        RTT::base::OutputPortInterface* const repeated = player_.port(topic, problem);
        if (!repeated) {
            problems[port] = problem;
            continue;
        }
        if (!problem.empty()) RTT::log(RTT::Warning) << problem << RTT::endlog();
        addAt(component, port, *repeated);
    }
}

}  // namespace OCL::schedule
