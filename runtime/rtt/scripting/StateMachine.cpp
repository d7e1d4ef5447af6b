// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/StateMachine.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/fosi.h>
#include <rtt/scripting/detail/execute/log_diagnostics.hpp>
#include <rtt/scripting/detail/machine/machine_claim.hpp>
#include <rtt/scripting/detail/machine/machine_core.hpp>
#include <rtt/scripting/detail/machine/machine_event.hpp>

#include <diag/print.hpp>

#include <unistd.h>

namespace RTT::scripting {

namespace {

constexpr std::int64_t kPatience = 5000000000;   // for commands, in ns
constexpr std::int64_t kBringDown = 1000000000;  // for a machine to come to its end
constexpr unsigned kBetweenCycles = 500;         // in bringDown(), in us

const char* nameOf(StateMachine::StateMachineStatus status) {
    switch (status) {
        case StateMachine::Status::inactive: return "inactive";
        case StateMachine::Status::activating: return "activating";
        case StateMachine::Status::active: return "active";
        case StateMachine::Status::requesting: return "requesting";
        case StateMachine::Status::running: return "running";
        case StateMachine::Status::stopping: return "stopping";
        case StateMachine::Status::stopped: return "stopped";
        case StateMachine::Status::resetting: return "resetting";
        case StateMachine::Status::deactivating: return "deactivating";
        case StateMachine::Status::paused: return "paused";
        case StateMachine::Status::error: return "error";
        case StateMachine::Status::unloaded: break;
    }
    return "unloaded";
}

}  // namespace

class StateMachine::Execution final : public detail::MachineObserver {
public:
    explicit Execution(std::unique_ptr<detail::MachineModel> made) : model(std::move(made)), core(*model, *this) {}

    void did(const char* what, const std::string& state) override {
        log(Info) << '[' << nameOf(core.status()) << "] state machine '" << model->name << "' " << what << " state '"
                  << state << '\'' << endlog();
    }
    void failed(const oroforge::diag::Location& where, const std::string& why) override {
        const detail::MachineState* const state = core.state();
        oroforge::diag::Sink sink;
        sink.error(where, "OPS400",
                   "state machine '" + model->name + "' failed" + (state ? " in state '" + state->name + "'" : "") +
                       ": " + why);
        oroforge::diag::SourceCache lines;
        if (model->source) lines.add(model->source->name, model->source->text);
        detail::logDiagnostics(sink, lines);
        const os::MutexLock lock(error_lock_);
        error_ = oroforge::diag::toString(sink.all().front());
    }
    std::string error() const {
        const os::MutexLock lock(error_lock_);
        return error_;
    }
    /** Takes the waiting events; true if one of them causes a transition. The caller must have the machine. */
    bool takeEvents();
    /** Stops and deactivates the machine, which the caller must have; false if that takes too long. */
    bool goDown();
    detail::MachineState* find(const std::string& name) {
        for (detail::MachineState& state : model->states)
            if (state.name == name) return &state;
        return nullptr;
    }

    const std::unique_ptr<detail::MachineModel> model;
    detail::MachineCore core;
    detail::MachineOwner owner{0};
    // Used only by the engine's thread.
    bool executing = false;
    boost::shared_ptr<StateMachine> self;  ///< keeps it while it is executed after it was unloaded

private:
    mutable os::Mutex error_lock_;  // locked only after a failure
    std::string error_;
};

StateMachine::StateMachine(std::unique_ptr<detail::MachineModel> model) : execution_(new Execution(std::move(model))) {}

StateMachine::~StateMachine() {
    if (ExecutionEngine* const engine = getEngine()) engine->removeFunction(this);
}

// Without a period, nothing else makes the engine execute a cycle.
void StateMachine::askForCycle() {
    wake();
    ExecutionEngine* const engine = getEngine();
    if (!engine) return;
    const internal::EngineGate::Visit visit(*engine->gate());
    if (visit.activity()) visit.activity()->timeout();
}

template <class Command>
bool StateMachine::command(const char* name, Command command) {
    if (!isLoaded()) return false;
    bool claimed = false, done = false;
    if (const auto claim = detail::MachineClaim::within(execution_->owner, kPatience); claim) {
        done = command(execution_->core);
        claimed = true;
    }
    if (claimed) {
        wake();
        std::atomic_thread_fence(std::memory_order_seq_cst);  // see takeEvents()
        const auto& events = execution_->model->queue;
        if (events && !events->empty()) askForCycle();
        return done;
    }
    log(Error) << "state machine '" << getName() << "': " << name << "() waited for " << kPatience / 1000000000
               << " s and gave up: a program that began in line " << getLineNumber() << " does not return" << endlog();
    return false;
}

bool StateMachine::activate() {
    return command("activate", [](detail::MachineCore& core) { return core.activate(); });
}

bool StateMachine::automatic() {
    return command("automatic", [](detail::MachineCore& core) { return core.automatic(); });
}

bool StateMachine::reactive() {
    return command("reactive", [](detail::MachineCore& core) { return core.reactive(); });
}

bool StateMachine::reset() {
    return command("reset", [](detail::MachineCore& core) { return core.reset(); });
}

bool StateMachine::deactivate() {
    return command("deactivate", [](detail::MachineCore& core) { return core.deactivate(); });
}

bool StateMachine::pause() { return request(&detail::MachineCore::pause); }
bool StateMachine::step() { return request(&detail::MachineCore::step); }
bool StateMachine::stop() { return request(&detail::MachineCore::stop); }

bool StateMachine::request(bool (detail::MachineCore::*what)()) {
    const bool accepted = isLoaded() && (execution_->core.*what)();
    if (accepted) wake();
    return accepted;
}

bool StateMachine::requestState(const std::string& state) {
    detail::MachineState* const target = execution_->find(state);
    const bool accepted =
        target && command("requestState", [&](detail::MachineCore& core) { return core.requestState(*target); });
    if (accepted) askForCycle();
    return accepted;
}

bool StateMachine::react(detail::OperationEvent& event, void* const* arguments) {
    const auto claim = detail::MachineClaim::soon(execution_->owner);
    if (!claim) return false;
    bool accepted = !claim.nested() && execution_->takeEvents();  // earlier events first
    event.hold(arguments);
    accepted = (isLoaded() && execution_->core.happened(event)) || accepted;
    if (accepted) askForCycle();
    return true;
}

void StateMachine::takeEvents() {
    // Either this finds the machine free, or the thread that gives it back finds the events.
    std::atomic_thread_fence(std::memory_order_seq_cst);
    const auto claim = detail::MachineClaim::soon(execution_->owner);
    if (claim && isLoaded() && execution_->takeEvents()) askForCycle();
}

bool StateMachine::Execution::takeEvents() {
    bool accepted = false;
    if (!model->queue) return accepted;
    model->queue->takeAll([&](detail::MachineEvent& event) { accepted = core.happened(event) || accepted; });
    if (const unsigned lost = model->queue->takeLost())
        log(Warning) << "state machine '" << model->name << "' has lost " << lost << (lost == 1 ? " event" : " events")
                     << ": of each operation, " << detail::OperationEvent::kMostWaiting
                     << " calls can wait for it, and then another thread had it, or its component was busy" << endlog();
    return accepted;
}

void StateMachine::trace(bool on) { execution_->core.setTraced(on); }

const std::string& StateMachine::getName() const { return execution_->model->name; }
const std::string& StateMachine::getText() const { return execution_->model->text; }
int StateMachine::getFirstLine() const { return static_cast<int>(execution_->model->firstLine); }
int StateMachine::getLineNumber() const { return static_cast<int>(execution_->core.line()); }

StateMachine::StateMachineStatus StateMachine::getStatus() const {
    return isLoaded() ? execution_->core.status() : Status::unloaded;
}

std::string StateMachine::getStatusStr() const { return nameOf(getStatus()); }

std::string StateMachine::getCurrentStateName() const {
    const detail::MachineState* const state = execution_->core.state();
    return state ? state->name : std::string();
}

std::vector<std::string> StateMachine::getStateList() const {
    std::vector<std::string> names;
    for (const detail::MachineState& state : execution_->model->states) names.push_back(state.name);
    return names;
}

StateInterface::~StateInterface() = default;

StateInterface* StateMachine::currentState() const { return execution_->core.state(); }
StateInterface* StateMachine::getInitialState() const { return execution_->model->first; }
StateInterface* StateMachine::getFinalState() const { return execution_->model->last; }
StateInterface* StateMachine::getState(const std::string& name) const { return execution_->find(name); }

bool StateMachine::inState(const std::string& name) const {
    const detail::MachineState* const state = execution_->core.state();
    return state && state->name == name;
}

bool StateMachine::inInitialState() const {
    const detail::MachineState* const state = execution_->core.state();
    return state && state == execution_->model->first;
}

bool StateMachine::inFinalState() const {
    const detail::MachineState* const state = execution_->core.state();
    return state && state == execution_->model->last;
}

bool StateMachine::inTransition() const { return execution_->core.inTransition(); }
bool StateMachine::isActive() const { return isLoaded() && execution_->core.state(); }

bool StateMachine::isReactive() const {
    const StateMachineStatus status = getStatus();
    return status == Status::active || status == Status::requesting;
}

std::string StateMachine::getError() const { return inError() ? execution_->error() : std::string(); }

const StateMachine::ChildList& StateMachine::getChildren() const { return execution_->model->children; }
boost::shared_ptr<Service> StateMachine::getService() const { return execution_->model->service; }

bool StateMachine::execute() {
    // Skipped while a thread gives a command, because that thread executes what is pending.
    boost::shared_ptr<StateMachine> self;
    const bool outer = !execution_->executing;
    execution_->executing = true;
    if (const auto claim = detail::MachineClaim::now(execution_->owner); claim && !claim.nested()) {
        execution_->takeEvents();
        execution_->core.cycle();
    }
    if (outer) {
        execution_->executing = false;
        if (execution_->self) self.swap(execution_->self);
    }
    return true;
}

// Only a thread that has the machine can tell. For a running one, which is asked in each step, the status is enough.
bool StateMachine::isIdle() const {
    switch (execution_->core.status()) {
        case Status::inactive:
        case Status::stopped:
        case Status::paused:
        case Status::error: break;
        default: return false;
    }
    {
        const auto claim = detail::MachineClaim::now(execution_->owner);
        if (!claim || claim.nested() || !execution_->core.isIdle()) return false;
    }
    // An event may have come while this had the machine, see takeEvents().
    std::atomic_thread_fence(std::memory_order_seq_cst);
    const auto& events = execution_->model->queue;
    return !events || events->empty();
}

void StateMachine::outliveExecution() {
    if (execution_->executing) execution_->self = shared_from_this();
}

bool StateMachine::Execution::goDown() {
    const std::int64_t end = rtos_get_time_ns() + kBringDown;
    const auto comesTo = [&](auto... goals) {
        while (((core.status() != goals) && ...)) {
            if (rtos_get_time_ns() >= end) return false;
            usleep(kBetweenCycles);
            core.cycle();
            // The machine's programs may be waiting for its sub machines.
            for (const StateMachinePtr& child : model->children) child->execute();
        }
        return true;
    };
    if (core.status() != Status::inactive && core.status() != Status::error && core.status() != Status::deactivating) {
        core.stopNow();
        if (!comesTo(Status::stopped, Status::error)) return false;
    }
    // In error, only a second deactivate() skips the exit program.
    if (core.status() != Status::inactive && core.status() != Status::deactivating) core.deactivate();
    if (!comesTo(Status::inactive, Status::error)) return false;
    if (core.status() == Status::error) core.deactivate();
    return true;
}

bool StateMachine::bringDown() {
    const auto claim = detail::MachineClaim::within(execution_->owner, kBringDown);
    if (claim.nested()) {
        log(Error) << "state machine '" << getName() << "' cannot be unloaded: one of its own programs asks for it"
                   << endlog();
        return false;
    }
    const bool down = claim && execution_->goDown();
    wake();
    if (!down) {
        log(Critical) << "state machine '" << getName() << "' cannot be unloaded: it does not leave state '"
                      << getCurrentStateName() << "', line " << getLineNumber() << endlog();
        return false;
    }
    for (const StateMachinePtr& child : getChildren())
        if (!child->bringDown()) return false;
    return true;
}

}  // namespace RTT::scripting
