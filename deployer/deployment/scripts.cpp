// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "scripts.hpp"

#include "session.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/HookInProgress.hpp>

#include <exception>

namespace OCL::deploy {
namespace {

struct Interpreter {
    const char* service;
    const char* operation;
};

Interpreter interpreterOf(ScriptPlan::Kind kind, const std::string& file) {
    const std::string lua = ".lua";
    if (kind == ScriptPlan::Program) return {"scripting", "loadPrograms"};
    if (kind == ScriptPlan::StateMachine) return {"scripting", "loadStateMachines"};
    if (file.size() > lua.size() && file.compare(file.size() - lua.size(), lua.size(), lua) == 0)
        return {"Lua", "exec_file"};
    return {"scripting", "runScript"};
}

}  // namespace

std::string serviceFor(ScriptPlan::Kind kind, const std::string& file) { return interpreterOf(kind, file).service; }

bool runScript(RTT::TaskContext& component, ScriptPlan::Kind kind, const std::string& file, std::string& error) {
    const Interpreter interpreter = interpreterOf(kind, file);
    const std::string service = std::string("the service '") + interpreter.service + "'";
    if (!loadService(component, interpreter.service)) {
        error = service + " is not installed";
        return false;
    }
    RTT::OperationCaller<bool(const std::string&)> run(
        component.provides()->getService(interpreter.service)->getOperation(interpreter.operation));
    if (!run.ready()) {
        error = service + " has no operation '" + interpreter.operation + "'";
        return false;
    }
    const RTT::internal::HookInProgress here(&component, "a script");
    try {
        if (run(file)) return true;
        error = "the log says why";
    } catch (const std::exception& thrown) {
        error = thrown.what();
    }
    return false;
}

}  // namespace OCL::deploy
