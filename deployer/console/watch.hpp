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
 * While the user watches a component from outside: the console's own component has a port for each port of the other one, of
 * the same name and the opposite direction, connected to it, and has it as its peer.
 */
class Watch {
public:
    Watch(RTT::TaskContext& self, RTT::TaskContext& watched);
    /** Removes the ports. The watched component may be gone. */
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    /** Those ports whose names the console's component has already, or that cannot be connected. */
    const std::vector<std::string>& missing() const { return missing_; }

private:
    RTT::TaskContext& self_;
    const std::string peer_;
    std::vector<std::unique_ptr<RTT::base::PortInterface>> ports_;
    std::vector<std::string> missing_;
};

}  // namespace OCL::console

#endif
