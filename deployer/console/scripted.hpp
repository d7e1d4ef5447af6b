// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Programs and state machines of a component, as its service "scripting" tells them.
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
    std::string state;   ///< of a machine, if it is in one
    std::string text;
    int line = 0;       ///< of what comes next; 0: nothing
    int firstLine = 1;  ///< where the text begins in its file
};

/** Without their texts. Empty without the service. */
std::vector<Scripted> scriptedIn(RTT::TaskContext& component, bool machines);
/** False if there is none of that name. */
bool findScripted(RTT::TaskContext& component, const std::string& name, Scripted& found);
/** The names of all. */
std::vector<std::string> scriptedNames(RTT::TaskContext& component);

}  // namespace OCL::console

#endif
