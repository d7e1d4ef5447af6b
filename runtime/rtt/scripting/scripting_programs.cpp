// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The functions of a scripting service for programs.
#include <rtt/TaskContext.hpp>
#include <rtt/internal/calls/failed.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/detail/service/loaded.hpp>
#include <rtt/scripting/detail/execute/program.hpp>

#include <diag/nearest_match.hpp>

namespace RTT::scripting {

bool ScriptingService::loadProgram(ProgramInterfacePtr program) {
    if (!program || !getOwner()) return false;
    const std::string name = program->getName(), what = "program '" + name + "'";
    const std::string taken = nameInUse(name);
    if (!taken.empty()) return refuse(what, taken);
    announce(what);
    Service& component = *getOwner()->provides();
    component.addService(detail::makeProgramService(program, *getOwner()));
    if (!getOwner()->engine()->runFunction(program.get())) {
        component.removeService(name);
        return refuse(what, "the engine of component '" + getOwner()->getName() + "' does not take it");
    }
    loaded_->programs.add(name, program);
    return true;
}

bool ScriptingService::unloadProgram(const std::string& name) {
    if (takeOutProgram(name)) return true;
    return internal::failed("program '" + name + "' cannot be unloaded: " +
                            (hasProgram(name) ? "its engine does not let it go"
                                              : "there is none of that name" +
                                                    oroforge::diag::didYouMean(name, loaded_->programs.names())));
}

bool ScriptingService::unloadProgram(const std::string& name, bool do_throw) {
    const bool done = unloadProgram(name);
    if (do_throw && !done) throw program_unload_exception("program '" + name + "' cannot be unloaded");
    return done;
}

bool ScriptingService::takeOutProgram(const std::string& name) {
    ProgramInterfacePtr program = getProgram(name);
    if (!program) return false;
    program->stop();
    ExecutionEngine* const engine = program->getEngine();
    if (engine && !engine->removeFunction(program.get())) return false;
    if (getOwner()) getOwner()->provides()->removeService(name);
    loaded_->programs.remove(name);
    retire(std::move(program));
    loaded_->retired.dropUnused();
    return true;
}

std::vector<std::string> ScriptingService::getProgramList() const { return loaded_->programs.names(); }

ProgramInterfacePtr ScriptingService::getProgram(const std::string& name) const { return loaded_->programs.find(name); }

bool ScriptingService::hasProgram(const std::string& name) const { return getProgram(name) != nullptr; }

bool ScriptingService::startProgram(const std::string& name) {
    return loaded_->programs.ask(name, false, &ProgramInterface::start);
}

bool ScriptingService::stopProgram(const std::string& name) {
    return loaded_->programs.ask(name, false, &ProgramInterface::stop);
}

bool ScriptingService::stepProgram(const std::string& name) {
    return loaded_->programs.ask(name, false, &ProgramInterface::step);
}

bool ScriptingService::pauseProgram(const std::string& name) {
    return loaded_->programs.ask(name, false, &ProgramInterface::pause);
}

bool ScriptingService::isProgramRunning(const std::string& name) const {
    return getProgramStatus(name) == ProgramInterface::Status::running;
}

bool ScriptingService::isProgramPaused(const std::string& name) const {
    return getProgramStatus(name) == ProgramInterface::Status::paused;
}

bool ScriptingService::inProgramError(const std::string& name) const {
    return getProgramStatus(name) == ProgramInterface::Status::error;
}

ScriptingService::ProgramStatus ScriptingService::getProgramStatus(const std::string& name) const {
    return loaded_->programs.ask(name, ProgramInterface::Status::unknown, &ProgramInterface::getStatus);
}

std::string ScriptingService::getProgramStatusStr(const std::string& name) const {
    return loaded_->programs.ask(name, std::string("unknown"), &ProgramInterface::getProgramStatusStr);
}

int ScriptingService::getProgramLine(const std::string& name) const {
    return loaded_->programs.ask(name, -1, &ProgramInterface::getLineNumber);
}

std::string ScriptingService::getProgramText(const std::string& name) const {
    return loaded_->programs.ask(name, std::string(), &ProgramInterface::getText);
}

}  // namespace RTT::scripting
