// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "scripts.hpp"

#include "session.hpp"
#include "xml_to_plan.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>

#include <algorithm>
#include <exception>

namespace OCL::deploy {
namespace {

struct Interpreter {
    const char* service;
    const char* operation;
};

Interpreter interpreterOf(ScriptPlan::Kind kind, const std::string& file) {
    if (kind == ScriptPlan::Program) return {"scripting", "loadPrograms"};
    if (kind == ScriptPlan::StateMachine) return {"scripting", "loadStateMachines"};
    if (isLua(file)) return {"Lua", "exec_file"};
    return {"scripting", "runScript"};
}

/** Loads the service of an interpreter. Lua scripts may use rttlib without asking for it. */
bool loadInterpreter(RTT::TaskContext& component, const std::string& service) {
    const bool isThere = component.provides()->hasService(service);
    if (!loadService(component, service)) return false;
    if (isThere || service != "Lua") return true;
    RTT::OperationCaller<bool(const std::string&)> run(
        component.provides()->getService(service)->getOperation("exec_str"));
    if (run.ready()) (void)run("pcall(require, 'rttlib')");
    return true;
}

const char kProgramList[] = "getProgramList", kMachineList[] = "getStateMachineList";

/** An operation of the component's scripting service; not ready if there is none. */
template <class Signature>
RTT::OperationCaller<Signature> scripting(RTT::TaskContext& component, const std::string& operation) {
    const RTT::Service::shared_ptr own = component.provides();
    if (!own->hasService("scripting")) return {};
    return RTT::OperationCaller<Signature>(own->getService("scripting")->getOperation(operation));
}

typedef std::vector<std::string> Names;

Names namesBy(RTT::TaskContext& component, const char* list) {
    RTT::OperationCaller<Names()> names = scripting<Names()>(component, list);
    return names.ready() ? names() : Names();
}

/** The names that are not in `without`. */
Names but(const Names& names, const Names& without) {
    Names result;
    for (const std::string& name : names)
        if (std::find(without.begin(), without.end(), name) == without.end()) result.push_back(name);
    return result;
}

/** Unloads the programs and state machines that still exist. */
void unload(RTT::TaskContext& component, const LoadedScript& loaded) {
    const auto remove = [&](const Names& names, const char* list, const char* operation) {
        RTT::OperationCaller<bool(const std::string&)> one = scripting<bool(const std::string&)>(component, operation);
        const Names present = namesBy(component, list);
        for (auto name = names.rbegin(); one.ready() && name != names.rend(); ++name)
            if (std::find(present.begin(), present.end(), *name) != present.end()) (void)one(*name);
    };
    remove(loaded.machines, kMachineList, "unloadStateMachine");
    remove(loaded.programs, kProgramList, "unloadProgram");
}

std::vector<LoadedScript>::const_iterator findIn(const std::vector<LoadedScript>& list, const ScriptPlan& script) {
    return std::find_if(list.begin(), list.end(),
                        [&](const LoadedScript& one) { return isSameStatement(one.script, script); });
}

}  // namespace

bool isLua(const std::string& file) {
    const std::string lua = ".lua";
    return file.size() > lua.size() && file.compare(file.size() - lua.size(), lua.size(), lua) == 0;
}

std::string luaFault(RTT::TaskContext& component, const std::string& file) {
    if (!loadInterpreter(component, "Lua")) return "the service 'Lua' is not installed";
    RTT::OperationCaller<std::string(const std::string&)> check(
        component.provides()->getService("Lua")->getOperation("check_file"));
    return check.ready() ? check(file) : "the service 'Lua' has no operation 'check_file'";
}

std::string serviceFor(ScriptPlan::Kind kind, const std::string& file) { return interpreterOf(kind, file).service; }

bool runScript(RTT::TaskContext& component, ScriptPlan::Kind kind, const std::string& file, std::string& error) {
    const Interpreter interpreter = interpreterOf(kind, file);
    const std::string service = std::string("the service '") + interpreter.service + "'";
    // A component of Lua has an interpreter itself, in which functions are its hooks.
    const bool isOfLua = isLua(file) && component.provides()->getPart(interpreter.operation);
    if (!isOfLua && !loadInterpreter(component, interpreter.service)) {
        error = service + " is not installed";
        return false;
    }
    const RTT::Service::shared_ptr owner =
        isOfLua ? component.provides() : component.provides()->getService(interpreter.service);
    RTT::OperationCaller<bool(const std::string&)> run(owner->getOperation(interpreter.operation),
                                                       RTT::internal::GlobalEngine::Instance());
    if (!run.ready()) {
        error = service + " has no operation '" + interpreter.operation + "'";
        return false;
    }
    const RTT::internal::HookInProgress here(&component, "a script");
    try {
        if (run(file)) return true;
    } catch (const std::exception& thrown) {
        error = thrown.what();
    }
    return false;
}

bool runScript(ComponentRecord& record, const ScriptPlan& script, std::string& error) {
    RTT::TaskContext& component = *record.instance;
    if (const auto earlier = findIn(record.loaded, script); earlier != record.loaded.end()) {
        unload(component, *earlier);
        record.loaded.erase(earlier);
    }
    const Names programs = namesBy(component, kProgramList), machines = namesBy(component, kMachineList);
    const bool ran = runScript(component, script.kind, resolveFile(script.file), error);
    LoadedScript loaded{script, but(namesBy(component, kProgramList), programs),
                        but(namesBy(component, kMachineList), machines)};
    if (!loaded.programs.empty() || !loaded.machines.empty()) record.loaded.push_back(std::move(loaded));
    return ran;
}

void unloadScripts(RTT::TaskContext& component, const std::vector<LoadedScript>& now,
                   const std::vector<LoadedScript>& before) {
    for (auto script = now.rbegin(); script != now.rend(); ++script)
        if (findIn(before, script->script) == before.end()) unload(component, *script);
}

}  // namespace OCL::deploy
