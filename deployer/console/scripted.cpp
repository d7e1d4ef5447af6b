// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "scripted.hpp"

#include <rtt/scripting/Scripting.hpp>
#include <rtt/scripting/ScriptingService.hpp>

#include <algorithm>

namespace OCL::console {
namespace {

boost::shared_ptr<RTT::Scripting> scriptingOf(RTT::TaskContext& component) {
    // A question must not load the service.
    if (!component.provides()->hasService("scripting")) return nullptr;
    return component.getProvider<RTT::Scripting>("scripting");
}

Scripted describe(RTT::Scripting& scripting, const std::string& name, bool machine) {
    Scripted made;
    made.name = name;
    made.machine = machine;
    made.status = machine ? scripting.getStateMachineStatusStr(name) : scripting.getProgramStatusStr(name);
    if (machine) made.state = scripting.getStateMachineState(name);
    return made;
}

}  // namespace

std::vector<Scripted> scriptedIn(RTT::TaskContext& component, bool machines) {
    std::vector<Scripted> all;
    const auto scripting = scriptingOf(component);
    if (!scripting) return all;
    for (const std::string& name : machines ? scripting->getStateMachineList() : scripting->getProgramList())
        all.push_back(describe(*scripting, name, machines));
    return all;
}

bool findScripted(RTT::TaskContext& component, const std::string& name, Scripted& found) {
    const auto scripting = scriptingOf(component);
    if (!scripting) return false;
    const bool machine = scripting->hasStateMachine(name);
    if (!machine && !scripting->hasProgram(name)) return false;
    found = describe(*scripting, name, machine);
    found.text = machine ? scripting->getStateMachineText(name) : scripting->getProgramText(name);
    // Scripts of another process do not report the place of their texts.
    const auto local =
        boost::dynamic_pointer_cast<RTT::scripting::ScriptingService>(component.provides()->getService("scripting"));
    if (!local) return true;
    // It may have been unloaded.
    if (const auto of = local->getStateMachine(name); machine && of)
        found.firstLine = of->getFirstLine();
    else if (const auto program = local->getProgram(name); !machine && program)
        found.firstLine = program->getFirstLine();
    else
        return false;
    found.line = machine ? scripting->getStateMachineLine(name) : scripting->getProgramLine(name);
    return true;
}

std::vector<std::string> scriptedNames(RTT::TaskContext& component) {
    std::vector<std::string> names;
    for (const bool machines : {false, true})
        for (const Scripted& each : scriptedIn(component, machines)) names.push_back(each.name);
    return names;
}

}  // namespace OCL::console
