// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "scripts.hpp"

#include "session.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>

#include <exception>

namespace OCL::deploy {
namespace {

const char* operationOf(ScriptPlan::Kind kind) {
    switch (kind) {
        case ScriptPlan::Run: return "runScript";
        case ScriptPlan::Program: return "loadPrograms";
        case ScriptPlan::StateMachine: return "loadStateMachines";
    }
    return "";
}

}  // namespace

bool runScript(RTT::TaskContext& component, ScriptPlan::Kind kind, const std::string& file, std::string& error) {
    if (!loadService(component, "scripting")) {
        error = "the service 'scripting' is not installed";
        return false;
    }
    RTT::OperationCaller<bool(const std::string&)> run(
        component.provides()->getService("scripting")->getOperation(operationOf(kind)));
    if (!run.ready()) {
        error = std::string("the service 'scripting' has no operation '") + operationOf(kind) + "'";
        return false;
    }
    try {
        if (run(file)) return true;
        error = "the script failed";
    } catch (const std::exception& thrown) {
        error = thrown.what();
    }
    return false;
}

}  // namespace OCL::deploy
