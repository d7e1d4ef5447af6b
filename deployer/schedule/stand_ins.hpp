// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEDULE_STAND_INS_HPP
#define OROFORGE_SCHEDULE_STAND_INS_HPP

#include <replay/player.hpp>

#include <map>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::schedule {

/** What a recording has, by components. */
class StandIns {
public:
    /** The player exists longer than this, and longer than the components that it makes. */
    explicit StandIns(replay::Player& player);

    bool hasComponent(const std::string& component) const;
    /** The port of a service is "service.port". */
    bool hasPort(const std::string& component, const std::string& port) const;
    std::vector<std::string> portsOf(const std::string& component) const;
    /** Adds the recorded ports to a component that has their component's name. `problems` gets, by port, why one is
        missing. */
    void addPorts(RTT::TaskContext& component, std::map<std::string, std::string>& problems);

private:
    replay::Player& player_;
    std::map<std::string, std::map<std::string, std::string>> topics_;  // by component and port
};

}  // namespace OCL::schedule

#endif
