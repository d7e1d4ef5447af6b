// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The programs and state machines of a component, from its service "scripting".
#ifndef OROFORGE_CONSOLE_SCRIPTED_HPP
#define OROFORGE_CONSOLE_SCRIPTED_HPP

#include <rtt/TaskContext.hpp>

#include <string>
#include <vector>

namespace OCL::console {

struct Scripted {
    std::string name;
    bool machine = false;
    std::string status;  ///< "running"
    std::string state;   ///< the state of a machine, if it is in one
    std::string text;
    int line = 0;       ///< the next line; 0 if there is none
    int firstLine = 1;  ///< where the text begins in its file
};

/** All programs or machines, without their texts; empty if the service is not loaded. */
std::vector<Scripted> scriptedIn(RTT::TaskContext& component, bool machines);
/** Finds a program or machine; false if there is none of that name. */
bool findScripted(RTT::TaskContext& component, const std::string& name, Scripted& found);
/** The names of all programs and machines. */
std::vector<std::string> scriptedNames(RTT::TaskContext& component);

}  // namespace OCL::console

#endif
