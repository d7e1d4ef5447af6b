// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/TaskCore.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>
#include <rtt/internal/engine/state_changes.hpp>

#include <exception>
#include <unistd.h>

namespace RTT::base {

using internal::EngineGate;
using internal::HookInProgress;

std::uint64_t TaskCore::pack(const States& states) {
    return std::uint64_t(std::uint32_t(states.changer)) << 32 | std::uint32_t(states.target) << 8 |
           std::uint32_t(states.state);
}

TaskCore::States TaskCore::states() const {
    const std::uint64_t packed = states_;
    return {static_cast<TaskState>(packed & 0xff), static_cast<TaskState>(packed >> 8 & 0xff),
            static_cast<int>(packed >> 32)};
}

// Changes all states at once by `modify`, which returns false for no change.
template <class Modify>
bool TaskCore::modify(Modify&& modify) {
    for (;;) {
        const States before = states();
        States after = before;
        if (!modify(after)) return false;
        std::uint64_t packed = pack(before);
        if (!states_.compare_exchange_strong(packed, pack(after))) continue;
        if (after.state != before.state) internal::countStateChange();
        return true;
    }
}

/** A thread's claim to change the state. A hook may make a change within the change that called it. */
class TaskCore::Change {
public:
    explicit Change(TaskCore& task) : task_(task) {
        const int self = static_cast<int>(gettid());
        granted_ = task_.modify([&](States& now) {
            outermost_ = now.changer == 0;
            if (!outermost_ && now.changer != self) return false;
            now.changer = self;
            return true;
        });
        outermost_ = outermost_ && granted_;
    }
    ~Change() { end(); }
    Change(const Change&) = delete;
    Change& operator=(const Change&) = delete;
    explicit operator bool() const { return granted_; }

    /** Enters the new state and ends the change in one operation, because the new state may cause the next change in
        the component's thread. False if the state is no longer `from`. */
    bool leave(TaskState from, TaskState to) {
        if (!task_.modify([&](States& now) {
                if (now.state != from) return false;
                now.state = now.target = to;
                if (outermost_) now.changer = 0;
                return true;
            }))
            return false;
        outermost_ = false;
        return true;
    }

private:
    void end() {
        if (outermost_) task_.modify([](States& now) { return now.changer = 0, true; });
    }
    TaskCore& task_;
    bool outermost_ = false, granted_ = false;
};

TaskCore::TaskCore(TaskState initial_state, const std::string& name)
    : ee(new ExecutionEngine(this)),
      mInitialState(initial_state),
      states_(pack({initial_state, initial_state, 0})),
      name_(name) {}

TaskCore::StateVariable& TaskCore::StateVariable::operator=(TaskState state) {
    task_.modify([this, state](States& now) {
        if (target_ || now.target == now.state) now.target = state;
        if (!target_) now.state = state;
        return true;
    });
    return *this;
}

TaskCore::~TaskCore() {
    if (ee->getActivity()) ee->getActivity()->stop();
    delete ee;
    internal::countStateChange();
    HookInProgress::forget(this);
}

const std::string& TaskCore::getName() const { return name_; }

// Sets the target, unless exception() or fatal() came first.
void TaskCore::aim(TaskState to) {
    modify([to](States& now) {
        if (now.target == Exception || now.target == FatalError) return false;
        now.target = to;
        return true;
    });
}

// Calls a hook that decides about a change of state. A hook that changes the state itself and yet returns true
// contradicts itself, which is treated like an exception.
template <class Hook>
TaskCore::Outcome TaskCore::callHook(const char* function, TaskState during, Hook hook) {
    const TaskState target = states().target;
    try {
        if (!hook()) return Outcome::Refused;
        const States now = states();
        // error() and recover() do not affect stop().
        const bool same = now.state == during || (during >= Running && now.state >= Running);
        if (same && now.target == target) return Outcome::Accepted;
        const Logger::In in(getName());
        log(Error) << getName() << ": the state of the component was changed while the hook of " << function
                   << " executed, and that returned true" << endlog();
        if (now.state == Exception || now.state == FatalError) return Outcome::Threw;
    } catch (const std::exception& e) {
        const Logger::In in(getName());
        log(Error) << getName() << ": the hook of " << function << " threw: " << e.what() << endlog();
    } catch (...) {
        const Logger::In in(getName());
        log(Error) << getName() << ": the hook of " << function << " threw something that is no std::exception"
                   << endlog();
    }
    exception();
    return Outcome::Threw;
}

namespace {

/** Logs the reason, because the caller only sees false. */
bool tellRefused(const TaskCore& task, Logger::LogLevel level, const char* function, const char* why) {
    const Logger::In in(task.getName());
    log(level) << task.getName() << ": " << function << " returns false: " << why << endlog();
    return false;
}

/** Why a component in this state does not start; null, for no message, if it is running already. */
const char* whyNotStarted(TaskCore::TaskState state) {
    switch (state) {
        case TaskCore::PreOperational: return "the component is not configured; configure() comes first";
        case TaskCore::Exception: return "the component is in state Exception; recover() comes first";
        case TaskCore::FatalError: return "the component has failed for good";
        default: return nullptr;
    }
}

}  // namespace

bool TaskCore::configure() {
    Change change(*this);
    const TaskState from = states().state;
    if (!change || (from != Stopped && from != PreOperational)) return false;
    aim(Stopped);
    switch (callHook("configure()", from, [this] {
        const HookInProgress hook(this, "configureHook()");
        return configureHook();
    })) {
        case Outcome::Accepted: return change.leave(from, Stopped);
        case Outcome::Refused:
            change.leave(from, PreOperational);
            return tellRefused(*this, Logger::Info, "configure()", "configureHook() did");
        case Outcome::Threw: break;
    }
    return false;
}

bool TaskCore::cleanup() {
    Change change(*this);
    if (!change || states().state != Stopped) return false;
    aim(PreOperational);
    cleaned_up_ = true;
    const Outcome outcome = callHook("cleanup()", Stopped, [this] {
        const HookInProgress hook(this, "cleanupHook()");
        return cleanupHook(), true;
    });
    cleaned_up_ = false;
    return outcome == Outcome::Accepted && change.leave(Stopped, PreOperational);
}

bool TaskCore::start() {
    Change change(*this);
    const TaskState from = states().state;
    const char* const why = change ? whyNotStarted(from) : nullptr;
    if (why) tellRefused(*this, Logger::Warning, "start()", why);
    if (!change || from != Stopped) return false;
    aim(Running);
    switch (callHook("start()", Stopped, [this] {
        const HookInProgress hook(this, "startHook()");
        return startHook();
    })) {
        case Outcome::Accepted:
            ++mStartCounter;
            // error() may have come at the last moment; the component then runs in RunTimeError.
            if (!change.leave(Stopped, Running) && states().state < Running) return false;
            if (mTriggerOnStart) trigger();
            return true;
        case Outcome::Refused:
            // The hook may have called error().
            if (!change.leave(Stopped, Stopped)) change.leave(RunTimeError, Stopped);
            return tellRefused(*this, Logger::Info, "start()", "startHook() did");
        case Outcome::Threw: break;
    }
    return false;
}

bool TaskCore::stop() {
    Change change(*this);
    if (!change || states().state < Running) return false;
    aim(Stopped);  // the engine calls no further hook
    const auto goOn = [this] { modify([](States& now) { return now.target = now.state, true; }); };
    try {
        if (!ee->stopTask()) {
            log(Error) << getName() << ": stop() failed, because the step that is being executed does not end"
                       << endlog();
            goOn();
            return false;
        }
    } catch (...) {
        goOn();  // breakUpdateHook() threw
        throw;
    }
    const TaskState from = states().state;
    if (from < Running) return false;  // that step ended in Exception or FatalError
    stopped_ = true;
    const Outcome outcome = callHook("stop()", from, [this] {
        const HookInProgress hook(this, "stopHook()");
        return stopHook(), true;
    });
    stopped_ = false;
    return outcome == Outcome::Accepted && (change.leave(Running, Stopped) || change.leave(RunTimeError, Stopped));
}

bool TaskCore::activate() {
    ee->startActivity();
    return isActive();
}

void TaskCore::error() {
    modify([](States& now) {
        if (now.target < Running) return false;
        now.state = now.target = RunTimeError;
        return true;
    });
}

bool TaskCore::recover() {
    TaskState from = Running;
    const bool recovered = modify([&](States& now) {
        from = now.state;
        if (from != Exception && from != RunTimeError) return false;
        if (now.target != from) return false;  // stop() is in progress
        now.state = now.target = from == Exception ? mInitialState : Running;
        return true;
    });
    // Requests to programs and state machines have used up their triggers meanwhile.
    if (recovered && from == Exception) trigger();
    return recovered;
}

void TaskCore::exception() {
    TaskState from = FatalError;
    if (!modify([&](States& now) {
            from = now.state;
            if (from == FatalError) return false;
            now.state = now.target = Exception;
            return true;
        }))
        return;
    try {
        // A hook that threw is not called again.
        if (from >= Running && !stopped_) {
            const HookInProgress hook(this, "stopHook()");
            stopHook();
        }
        if (from >= Stopped && mInitialState == PreOperational && !cleaned_up_) {
            const HookInProgress hook(this, "cleanupHook()");
            cleanupHook();
        }
        const HookInProgress hook(this, "exceptionHook()");
        exceptionHook();
        return;
    } catch (const std::exception& e) {
        const Logger::In in(getName());
        log(Error) << getName() << ": a hook threw while the component entered state Exception: " << e.what()
                   << endlog();
    } catch (...) {
        const Logger::In in(getName());
        log(Error) << getName() << ": a hook threw while the component entered state Exception" << endlog();
    }
    fatal();
}

void TaskCore::fatal() {
    modify([](States& now) { return now.state = now.target = FatalError, true; });
    ee->setFatalTask();
}

bool TaskCore::update() {
    const EngineGate::Visit visit(*ee->gate());
    return visit.activity() && visit.activity()->execute();
}

bool TaskCore::trigger() {
    const EngineGate::Visit visit(*ee->gate());
    return visit.activity() && visit.activity()->timeout();
}

bool TaskCore::isActive() const {
    const EngineGate::Visit visit(*ee->gate());
    return visit.activity() && visit.activity()->isActive();
}

Seconds TaskCore::getPeriod() const {
    const EngineGate::Visit visit(*ee->gate());
    return visit.activity() ? visit.activity()->getPeriod() : -1.0;
}

bool TaskCore::setPeriod(Seconds period) {
    const EngineGate::Visit visit(*ee->gate());
    return visit.activity() && visit.activity()->setPeriod(period);
}

unsigned TaskCore::getCpuAffinity() const {
    const EngineGate::Visit visit(*ee->gate());
    return visit.activity() ? visit.activity()->getCpuAffinity() : ~0u;
}

bool TaskCore::setCpuAffinity(unsigned cpu) {
    const EngineGate::Visit visit(*ee->gate());
    return visit.activity() && visit.activity()->setCpuAffinity(cpu);
}

// One bit operation, because each step calls it several times.
TaskCore::TaskState TaskCore::getTaskState() const { return static_cast<TaskState>(states_ & 0xff); }
TaskCore::TaskState TaskCore::getTargetState() const { return static_cast<TaskState>(states_ >> 8 & 0xff); }
bool TaskCore::isConfigured() const { return TaskCore::getTaskState() >= Stopped; }
bool TaskCore::isRunning() const { return TaskCore::getTaskState() >= Running; }
bool TaskCore::inFatalError() const { return TaskCore::getTaskState() == FatalError; }
bool TaskCore::inException() const { return TaskCore::getTaskState() == Exception; }
bool TaskCore::inRunTimeError() const { return TaskCore::getTaskState() == RunTimeError; }

bool TaskCore::configureHook() { return true; }
bool TaskCore::startHook() { return true; }
void TaskCore::updateHook() {}
bool TaskCore::breakUpdateHook() { return true; }
void TaskCore::errorHook() {}
void TaskCore::stopHook() {}
void TaskCore::cleanupHook() {}
void TaskCore::exceptionHook() {}
void TaskCore::dataOnPortCallback(PortInterface*) {}

}  // namespace RTT::base
