// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The functions of a scripting service for state machines.
#include <rtt/TaskContext.hpp>
#include <rtt/internal/calls/failed.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/detail/service/loaded.hpp>

#include <diag/nearest_match.hpp>

namespace RTT::scripting {

bool ScriptingService::loadStateMachine(StateMachinePtr machine) {
    if (!machine || !getOwner()) return false;
    const std::string name = machine->getName(), what = "state machine '" + name + "'";
    if (machine->isLoaded()) return refuse(what, "it is loaded already");
    Service& component = *getOwner()->provides();
    // The component has the service of a machine that a script made.
    const Service::shared_ptr service = machine->getService();
    if (!service || component.getService(name) != service) {
        const std::string taken = nameInUse(name);
        if (!taken.empty()) return refuse(what, taken);
        if (service) component.addService(service);
    }
    announce(what);
    if (addMachine(machine)) return true;
    removeMachine(machine);
    if (service) component.removeService(name);
    return refuse(what, "the engine of component '" + getOwner()->getName() + "' does not take it");
}

bool ScriptingService::addMachine(const StateMachinePtr& machine) {
    if (!getOwner()->engine()->runFunction(machine.get())) return false;
    loaded_->machines.add(machine->getName(), machine);
    for (const StateMachinePtr& child : machine->getChildren())
        if (!addMachine(child)) return false;
    return true;
}

// Removes sub machines after their machine, because it commands them. It stays known until all are removed, so that the
// caller can try again.
bool ScriptingService::removeMachine(const StateMachinePtr& machine) {
    ExecutionEngine* const engine = machine->getEngine();
    if (engine && !engine->removeFunction(machine.get())) return false;
    for (const StateMachinePtr& child : machine->getChildren())
        if (!removeMachine(child)) return false;
    loaded_->machines.remove(machine->getName());
    return true;
}

bool ScriptingService::unloadStateMachine(const std::string& name) {
    StateMachinePtr machine = getStateMachine(name);
    if (machine && name.find('.') == std::string::npos) return takeOutMachine(std::move(machine));
    return internal::failed(
        "state machine '" + name + "' cannot be unloaded: " +
        (machine ? "it is part of '" + name.substr(0, name.find('.')) + "'"
                 : "there is none of that name" + oroforge::diag::didYouMean(name, loaded_->machines.names())));
}

bool ScriptingService::unloadStateMachine(const std::string& name, bool do_throw) {
    const bool done = unloadStateMachine(name);
    if (do_throw && !done) throw program_unload_exception("state machine '" + name + "' cannot be unloaded");
    return done;
}

// The engine still executes it while it stops, because its programs may command its sub machines.
bool ScriptingService::takeOutMachine(StateMachinePtr machine) {
    if (!getOwner()) return removeMachine(machine);
    if (!machine->bringDown()) return false;
    if (!removeMachine(machine)) {
        return internal::failed("state machine '" + machine->getName() +
                                "' cannot be unloaded: its engine does not let it go");
    }
    if (machine->getService()) getOwner()->provides()->removeService(machine->getName());
    retire(machine);
    machine.reset();
    loaded_->retired.dropUnused();
    return true;
}

std::vector<std::string> ScriptingService::getStateMachineList() const { return loaded_->machines.names(); }

StateMachinePtr ScriptingService::getStateMachine(const std::string& name) const {
    return loaded_->machines.find(name);
}

bool ScriptingService::hasStateMachine(const std::string& name) const { return getStateMachine(name) != nullptr; }

bool ScriptingService::activateStateMachine(const std::string& name) {
    return loaded_->machines.ask(name, false, &StateMachine::activate);
}

bool ScriptingService::deactivateStateMachine(const std::string& name) {
    return loaded_->machines.ask(name, false, &StateMachine::deactivate);
}

bool ScriptingService::startStateMachine(const std::string& name) {
    return loaded_->machines.ask(name, false, &StateMachine::start);
}

bool ScriptingService::pauseStateMachine(const std::string& name) {
    return loaded_->machines.ask(name, false, &StateMachine::pause);
}

bool ScriptingService::stopStateMachine(const std::string& name) {
    return loaded_->machines.ask(name, false, &StateMachine::stop);
}

bool ScriptingService::resetStateMachine(const std::string& name) {
    return loaded_->machines.ask(name, false, &StateMachine::reset);
}

bool ScriptingService::requestStateMachineState(const std::string& name, const std::string& state) {
    const StateMachinePtr machine = getStateMachine(name);
    return machine && machine->requestState(state);
}

bool ScriptingService::isStateMachineActive(const std::string& name) const {
    return loaded_->machines.ask(name, false, &StateMachine::isActive);
}

bool ScriptingService::isStateMachineRunning(const std::string& name) const {
    return loaded_->machines.ask(name, false, &StateMachine::isRunning);
}

bool ScriptingService::isStateMachinePaused(const std::string& name) const {
    return getStateMachineStatus(name) == StateMachine::Status::paused;
}

bool ScriptingService::inStateMachineError(const std::string& name) const {
    return getStateMachineStatus(name) == StateMachine::Status::error;
}

bool ScriptingService::inStateMachineState(const std::string& name, const std::string& state) const {
    const StateMachinePtr machine = getStateMachine(name);
    return machine && machine->inState(state);
}

std::string ScriptingService::getStateMachineState(const std::string& name) const {
    return loaded_->machines.ask(name, std::string(), &StateMachine::getCurrentStateName);
}

ScriptingService::StateMachineStatus ScriptingService::getStateMachineStatus(const std::string& name) const {
    return loaded_->machines.ask(name, StateMachine::Status::unloaded, &StateMachine::getStatus);
}

std::string ScriptingService::getStateMachineStatusStr(const std::string& name) const {
    return loaded_->machines.ask(name, std::string("unloaded"), &StateMachine::getStatusStr);
}

int ScriptingService::getStateMachineLine(const std::string& name) const {
    return loaded_->machines.ask(name, -1, &StateMachine::getLineNumber);
}

std::string ScriptingService::getStateMachineText(const std::string& name) const {
    return loaded_->machines.ask(name, std::string(), &StateMachine::getText);
}

}  // namespace RTT::scripting
