// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/ScriptingService.hpp>

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/calls/failure_report.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt/scripting/detail/service/loaded.hpp>
#include <rtt/scripting/detail/execute/log_diagnostics.hpp>
#include <rtt/scripting/detail/execute/program.hpp>
#include <rtt/scripting/detail/service/script_runner.hpp>
#include <rtt/scripting/detail/syntax/script_text.hpp>

#include <diag/print.hpp>

#include <boost/make_shared.hpp>

#include <algorithm>
#include <utility>

namespace RTT::scripting {

namespace diag = oroforge::diag;
using detail::Contents;

namespace {

/** Runs a text; if that fails, `why` is its first error. */
bool runText(ScriptingService& service, const diag::FileName& name, const std::string& text, Contents contents,
             std::string* why = nullptr) {
    if (service.getOwner()) {
        detail::ScriptRunner runner(service, name, text);
        const bool done = runner.run(contents);
        if (why) *why = runner.firstError();
        return done;
    }
    const char* const reason = "a script cannot be run: service 'scripting' belongs to no component";
    log(Error) << reason << endlog();
    if (why) *why = reason;
    return false;
}

bool runFile(ScriptingService& service, const std::string& file, Contents contents, std::string* why = nullptr) {
    const std::string path = detail::ScriptRunner::locate(file);
    log(Info) << "running script " << path << endlog();
    diag::Sink sink;
    if (const auto text = detail::readScript(path, sink)) return runText(service, path, *text, contents, why);
    diag::SourceCache none;
    detail::logDiagnostics(sink, none);
    if (why && !sink.empty()) *why = diag::toString(sink.all().front());
    return false;
}

/** Returns the result of `run`, which logs why it fails. A calling script gets `why`. */
template <class Run>
bool told(const std::string& why, Run run) {
    bool done = false;
    {
        const internal::FailureReport::Pause others;
        done = run();
    }
    if (!done && !detail::ScriptRunner::isUnwinding()) (void)internal::FailureReport::give(why);
    return done;
}

/** Returns `done`, but throws if it is false and `wanted`. */
bool orThrow(bool done, bool wanted, const std::string& why) {
    if (wanted && !done) throw program_load_exception(why);
    return done;
}

}  // namespace

ScriptingService::shared_ptr ScriptingService::Create(TaskContext* parent) {
    if (const auto present = boost::dynamic_pointer_cast<ScriptingService>(parent->provides()->getService("scripting")))
        return present;
    const auto made = boost::make_shared<ScriptingService>(parent);
    return parent->provides()->addService(made) ? made : nullptr;
}

ScriptingService::ScriptingService(TaskContext* parent)
    : Service("scripting", parent),
      loaded_(std::make_unique<Loaded>(parent ? parent->provides() : Service::shared_ptr())) {
    doc("Runs scripts in this component, and keeps the programs and state machines they define.");
    addProperty("ZeroPeriodWarning", zero_period_warning_)
        .doc("Warn of programs and state machines that are loaded into a component without a period.");
    addProperty(loaded_->stepBudget);
    addScriptOperations();
    addProgramOperations();
    addStateMachineOperations();
    internal::FailureReport::add(*this);
}

namespace {

void outliveExecution(StateMachine& machine) {
    machine.outliveExecution();
    for (const StateMachinePtr& child : machine.getChildren()) outliveExecution(*child);
}

}  // namespace

// Exit programs of state machines would need the component, which may be gone.
ScriptingService::~ScriptingService() {
    internal::FailureReport::remove(*this);
    const Service::shared_ptr component = loaded_->component.lock();
    const bool alive = component && component->getOwner();
    const auto removeFrom = [&component](const std::string& name) {
        if (component) component->removeService(name);
    };
    for (const std::string& name : rootMachines()) {
        const StateMachinePtr machine = getStateMachine(name);
        if (alive) machine->bringDown();
        removeMachine(machine);
        outliveExecution(*machine);
        if (machine->getService()) removeFrom(name);
    }
    for (const std::string& name : loaded_->programs.names())
        if (takeOutProgram(name)) removeFrom(name);
}

std::vector<std::string> ScriptingService::rootMachines() const {
    std::vector<std::string> names = loaded_->machines.names();
    const auto isPart = [](const std::string& name) { return name.find('.') != std::string::npos; };
    names.erase(std::remove_if(names.begin(), names.end(), isPart), names.end());
    return names;
}

void ScriptingService::clear() {
    for (const std::string& name : rootMachines()) takeOutMachine(getStateMachine(name));
    for (const std::string& name : loaded_->programs.names()) takeOutProgram(name);
    loaded_->definitions.clear();
    Service::clear();
}

// -- Scripts --------------------------------------------------------------------------------------------------------

bool ScriptingService::eval(const std::string& code) {
    static const diag::FileName name("eval()");
    return evalInternal(name, code);
}

bool ScriptingService::evalInternal(const std::string& name, const std::string& code) {
    return told("could not run all of the text", [&] { return runText(*this, name, code, Contents::Everything); });
}

bool ScriptingService::runScript(const std::string& file) {
    return told("could not run script '" + file + "'", [&] { return runFile(*this, file, Contents::Everything); });
}

int ScriptingService::execute(const std::string& code) { return eval(code) ? 0 : -1; }
bool ScriptingService::doExecute(const std::string& code) { return eval(code); }

bool ScriptingService::load(const std::string& file, Kind kind, bool do_throw) {
    std::string why;
    const Contents contents = kind == Kind::Programs ? Contents::Programs : Contents::StateMachines;
    const bool done =
        told("could not load script '" + file + "'", [&] { return runFile(*this, file, contents, &why); });
    return orThrow(done, do_throw, why);
}

bool ScriptingService::load(const std::string& code, const std::string& name, Kind kind, bool do_throw) {
    std::string why;
    const Contents contents = kind == Kind::Programs ? Contents::Programs : Contents::StateMachines;
    const bool done = told("could not load the text", [&] { return runText(*this, name, code, contents, &why); });
    return orThrow(done, do_throw, why);
}

// -- Both kinds -----------------------------------------------------------------------------------------------------

std::string ScriptingService::nameInUse(const std::string& name) const {
    const char* const kind = hasProgram(name)                           ? "program"
                             : hasStateMachine(name)                    ? "state machine"
                             : getOwner()->provides()->hasService(name) ? "service"
                                                                        : nullptr;
    return kind ? detail::nameTaken(*getOwner(), kind) : std::string();
}

void ScriptingService::announce(const std::string& what) const {
    loaded_->retired.dropUnused();
    const std::string& component = getOwner()->getName();
    log(Info) << "loading " << what << " into component '" << component << "'" << endlog();
    if (zero_period_warning_ && getOwner()->getPeriod() == 0)
        log(Warning)
            << what << " is executed only when something wakes component '" << component
            << "', which has no period: give it one with setPeriod(), or set scripting.ZeroPeriodWarning to false"
            << endlog();
}

bool ScriptingService::refuse(const std::string& what, const std::string& why) {
    log(Error) << what << " cannot be loaded: " << why << endlog();
    return false;
}

// A machine that is unloaded while it is executed must live until that ends: this thread may execute it, or another one
// that called the removal while it was waiting.
void ScriptingService::retire(const StateMachinePtr& machine) {
    machine->outliveExecution();
    loaded_->retired.add(machine);
    for (const StateMachinePtr& child : machine->getChildren()) retire(child);
}

void ScriptingService::retire(ProgramInterfacePtr program) {
    if (dynamic_cast<const detail::Program*>(program.get()))
        loaded_->retired.add(std::move(program));
    else if (getOwner() && getOwner()->engine()->isStepping())
        loaded_->retired.keep(std::move(program));  // because it was written in C++
}

}  // namespace RTT::scripting

ORO_SERVICE_NAMED_PLUGIN(RTT::scripting::ScriptingService, "scripting")
