// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_REPLAY_PORTS_HPP
#define OROFORGE_REPLAY_REPLAY_PORTS_HPP

#include "../player.hpp"

#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/OutputPortInterface.hpp>

#include <string>
#include <utility>
#include <vector>

namespace OCL::replay {

/** The ports of a player in the services of a component, until they are removed again. */
class ReplayPorts {
public:
    explicit ReplayPorts(RTT::TaskContext& component) : component_(component) {}
    ~ReplayPorts() { remove(); }
    ReplayPorts(const ReplayPorts&) = delete;
    ReplayPorts& operator=(const ReplayPorts&) = delete;

    /** The port of the topic `/Camera/lens/focus` is `Camera.lens.focus`. False, with the reason, if there is a port of
        that name. */
    bool add(const Topic& topic, RTT::base::OutputPortInterface& port, std::string& why);
    void remove();

private:
    RTT::TaskContext& component_;
    std::vector<std::pair<RTT::Service::shared_ptr, std::string>> ports_;
    std::vector<std::pair<RTT::Service::shared_ptr, std::string>> services_;  // that were made, and in which
};

}  // namespace OCL::replay

#endif
