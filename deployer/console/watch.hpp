// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_WATCH_HPP
#define OROFORGE_CONSOLE_WATCH_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/base/PortInterface.hpp>

#include <memory>
#include <string>
#include <vector>

namespace OCL::console {

/**
 * Lets the user watch a component from outside: while it exists, the console's own component has that component as a
 * peer and has a port of the same name and the opposite direction, connected, for each of its ports.
 */
class Watch {
public:
    Watch(RTT::TaskContext& self, RTT::TaskContext& watched);
    /** Removes the ports and the peer. The watched component may have been destroyed. */
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    /** The ports whose names the console's component has already, or that cannot be connected. */
    const std::vector<std::string>& missing() const { return missing_; }

private:
    RTT::TaskContext& self_;
    const std::string peer_;
    std::vector<std::unique_ptr<RTT::base::PortInterface>> ports_;
    std::vector<std::string> missing_;
};

}  // namespace OCL::console

#endif
