// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations of the scripting service.
#include <rtt/scripting/ScriptingService.hpp>

namespace RTT::scripting {

namespace {
/** Selects the overload that takes only a text. */
constexpr auto ofName(bool (ScriptingService::*function)(const std::string&)) { return function; }
}  // namespace

void ScriptingService::addScriptOperations() {
    using S = ScriptingService;
    addOperation("eval", &S::eval, this)
        .doc("Runs the text of a script.")
        .arg("Code", "statements, functions, programs and state machines");
    addOperation("runScript", &S::runScript, this).doc("Runs a script file.").arg("Filename", "path of the script");
    addOperation("execute", &S::execute, this)
        .doc("Deprecated: use eval(). Returns 0 for true, -1 for false.")
        .arg("Code", "text of a script");
    addOperation("doExecute", &S::doExecute, this)
        .doc("Deprecated: another name of eval().")
        .arg("Code", "text of a script");
    addOperation("loadPrograms", ofName(&S::loadPrograms), this)
        .doc("Loads a file that has nothing but functions and programs.")
        .arg("Filename", "path of the script");
    addOperation("loadProgramText", &S::loadProgramText, this)
        .doc("Loads a text that has nothing but functions and programs.")
        .arg("Code", "text of the script");
    addOperation("loadStateMachines", ofName(&S::loadStateMachines), this)
        .doc("Loads a file that has nothing but state machines.")
        .arg("Filename", "path of the script");
    addOperation("loadStateMachineText", &S::loadStateMachineText, this)
        .doc("Loads a text that has nothing but state machines.")
        .arg("Code", "text of the script");
}

void ScriptingService::addProgramOperations() {
    using S = ScriptingService;
    const char* const name = "Name";
    const char* const which = "name of the program";
    addOperation("unloadProgram", ofName(&S::unloadProgram), this).doc("Removes a program.").arg(name, which);
    addOperation("getProgramList", &S::getProgramList, this).doc("The names of all programs.");
    addOperation("hasProgram", &S::hasProgram, this).doc("Is there such a program?").arg(name, which);
    addOperation("startProgram", &S::startProgram, this)
        .doc("Starts a program, or resumes it if it is paused.")
        .arg(name, which);
    addOperation("stopProgram", &S::stopProgram, this).doc("Stops a program.").arg(name, which);
    addOperation("stepProgram", &S::stepProgram, this)
        .doc("Executes one statement of a paused program.")
        .arg(name, which);
    addOperation("pauseProgram", &S::pauseProgram, this).doc("Pauses a program.").arg(name, which);
    addOperation("isProgramRunning", &S::isProgramRunning, this).doc("Is it running?").arg(name, which);
    addOperation("isProgramPaused", &S::isProgramPaused, this).doc("Is it paused?").arg(name, which);
    addOperation("inProgramError", &S::inProgramError, this).doc("Has a statement of it failed?").arg(name, which);
    addOperation("getProgramStatus", &S::getProgramStatus, this).doc("The status, for C++.").arg(name, which);
    addOperation("getProgramStatusStr", &S::getProgramStatusStr, this)
        .doc("The status: unknown, stopped, paused, running or error.")
        .arg(name, which);
    addOperation("getProgramLine", &S::getProgramLine, this)
        .doc("The line it is at; -1 if there is no such program.")
        .arg(name, which);
    addOperation("getProgramText", &S::getProgramText, this)
        .doc("Its text; empty if there is no such program.")
        .arg(name, which);
}

void ScriptingService::addStateMachineOperations() {
    using S = ScriptingService;
    const char* const name = "Name";
    const char* const which = "name of the state machine, as in root.sub";
    addOperation("unloadStateMachine", ofName(&S::unloadStateMachine), this)
        .doc("Stops, deactivates and removes a root machine.")
        .arg(name, which);
    addOperation("getStateMachineList", &S::getStateMachineList, this).doc("The names of all state machines.");
    addOperation("hasStateMachine", &S::hasStateMachine, this).doc("Is there such a state machine?").arg(name, which);
    addOperation("activateStateMachine", &S::activateStateMachine, this)
        .doc("Enters the initial state.")
        .arg(name, which);
    addOperation("deactivateStateMachine", &S::deactivateStateMachine, this)
        .doc("Leaves the current state and becomes inactive.")
        .arg(name, which);
    addOperation("startStateMachine", &S::startStateMachine, this)
        .doc("Lets it follow its transitions by itself.")
        .arg(name, which);
    addOperation("pauseStateMachine", &S::pauseStateMachine, this).doc("Pauses it.").arg(name, which);
    addOperation("stopStateMachine", &S::stopStateMachine, this).doc("Goes to the final state.").arg(name, which);
    addOperation("resetStateMachine", &S::resetStateMachine, this)
        .doc("Goes from the final to the initial state.")
        .arg(name, which);
    addOperation("requestStateMachineState", &S::requestStateMachineState, this)
        .doc("Goes to a state if a transition allows it.")
        .arg(name, which)
        .arg("StateName", "name of the state");
    addOperation("isStateMachineActive", &S::isStateMachineActive, this).doc("Is it in any state?").arg(name, which);
    addOperation("isStateMachineRunning", &S::isStateMachineRunning, this)
        .doc("Does it follow its transitions by itself?")
        .arg(name, which);
    addOperation("isStateMachinePaused", &S::isStateMachinePaused, this).doc("Is it paused?").arg(name, which);
    addOperation("inStateMachineError", &S::inStateMachineError, this)
        .doc("Has a statement of it failed?")
        .arg(name, which);
    addOperation("inStateMachineState", &S::inStateMachineState, this)
        .doc("Is it in this state?")
        .arg(name, which)
        .arg("State", "name of the state");
    addOperation("getStateMachineState", &S::getStateMachineState, this)
        .doc("The name of its state; empty if it is in none.")
        .arg(name, which);
    addOperation("getStateMachineStatus", &S::getStateMachineStatus, this).doc("The status, for C++.").arg(name, which);
    addOperation("getStateMachineStatusStr", &S::getStateMachineStatusStr, this)
        .doc(
            "The status: inactive, activating, active, requesting, running, stopping, stopped, resetting, "
            "deactivating, paused, error or unloaded.")
        .arg(name, which);
    addOperation("getStateMachineLine", &S::getStateMachineLine, this)
        .doc("The line it is at; -1 if there is no such state machine.")
        .arg(name, which);
    addOperation("getStateMachineText", &S::getStateMachineText, this)
        .doc("Its text; empty if there is no such state machine.")
        .arg(name, which);
}

}  // namespace RTT::scripting
