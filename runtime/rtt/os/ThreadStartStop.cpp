// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/detail/thread_state.hpp>
#include <rtt/os/os_log.hpp>

#include <cstdio>
#include <cxxabi.h>
#include <exception>

namespace RTT::os {

bool Thread::isActive() const { return state_->isPast(State::kActive); }

bool Thread::isRunning() const { return isPeriodic() ? state_->running.load() : state_->session != 0; }

bool Thread::start() {
    if (!state_->joinable) return false;
    if (!state_->change(State::kIdle, State::kStarting)) return startAgain();
    // A thread that stopped itself may still be in its last cycle.
    if (!isSelf() && !waitForSessionEnd(getStopTimeout())) {
        detail::log(detail::LogError, "Thread",
                    "cannot start thread '" + state_->name + "': it has not finished its previous cycle yet");
        state_->life = State::kIdle;
        return false;
    }
    bool initialized = false;
    try {
        initialized = initialize();
    } catch (...) {
        state_->life = State::kIdle;
        throw;
    }
    if (!initialized) {
        state_->life = State::kIdle;
        return false;
    }
    state_->running = true;
    state_->life = State::kActive;
    state_->session.fetch_or(State::kDue);
    wake(kStartReason);
    return true;
}

bool Thread::startAgain() {
    if (state_->life != State::kActive || isPeriodic()) return false;
    state_->session.fetch_or(State::kDue);
    wake(kStartReason);
    return true;
}

bool Thread::stop() {
    if (!state_->change(State::kActive, State::kStopping)) {
        waitForOthersStop();
        return false;
    }
    state_->running = false;
    const bool self = isSelf();
    if (!self) wake(kStopReason);
    if (!isPeriodic() && state_->inUserCode != 0 && !mayBreakLoop()) {
        detail::log(detail::LogWarning, "Thread",
                    "cannot stop thread '" + state_->name + "': breakLoop() returned false while loop() is executing");
        return self ? goOn() : keepRunning();
    }
    if (self) return stopSelf();
    const Seconds timeout = getStopTimeout();
    if (!waitForSessionEnd(timeout)) {
        char seconds[32];
        std::snprintf(seconds, sizeof seconds, "%g", timeout);
        detail::log(detail::LogError, "Thread",
                    "cannot stop thread '" + state_->name + "': loop() or step() has not returned within " + seconds +
                        " s; setStopTimeout() changes that time");
        return keepRunning();
    }
    finalizeToIdle();
    return true;
}

// Exceptions must neither leave the thread between two states for ever nor leave a destructor that calls stop().
bool Thread::mayBreakLoop() {
    try {
        return breakLoop();
    } catch (const std::exception& e) {
        detail::log(detail::LogCritical, "Thread", "breakLoop() of thread '" + state_->name + "' threw: " + e.what());
    } catch (...) {
        detail::log(detail::LogCritical, "Thread", "breakLoop() of thread '" + state_->name + "' threw an exception");
    }
    return false;
}

void Thread::finalizeToIdle() {
    try {
        finalize();
    } catch (abi::__forced_unwind&) {
        state_->life = State::kIdle;
        throw;  // the thread is being cancelled: that must go on
    } catch (const std::exception& e) {
        detail::log(detail::LogCritical, "Thread", "finalize() of thread '" + state_->name + "' threw: " + e.what());
    } catch (...) {
        detail::log(detail::LogCritical, "Thread", "finalize() of thread '" + state_->name + "' threw an exception");
    }
    state_->life = State::kIdle;
}

// A thread that stopped itself, or that another thread is stopping, is not active any more but may still be executing.
// The caller of stop(), mostly a destructor, expects that it does not.
void Thread::waitForOthersStop() const {
    if (isSelf()) return;
    const nsecs deadline = detail::after(rtos_get_time_ns(), Seconds_to_nsecs(getStopTimeout()));
    while (const std::uint32_t busy = state_->session)
        // The end of the session wakes this thread. If the other one is active again, somebody has started it.
        if (state_->life == State::kActive || !detail::futexWait(state_->session, busy, deadline)) return;
}

// Called by the thread itself within its session, which ends when the current step returns because `running` is false.
bool Thread::stopSelf() {
    finalizeToIdle();
    return true;
}

// Called if stop() failed. A thread that destroys this one sets `exit` before it clears `running`, so that stays false.
bool Thread::goOn() {
    state_->running = true;
    if (state_->exit) state_->running = false;
    state_->life = State::kActive;
    detail::futexWakeAll(state_->session);  // for waitForOthersStop()
    return false;
}

// The same in another thread. If the session has seen `running` false and is about to end, a new one takes over.
bool Thread::keepRunning() {
    goOn();
    state_->session.fetch_or(State::kDue);
    wake(kStartReason);
    return false;
}

bool Thread::waitForSessionEnd(Seconds timeout) const {
    const nsecs deadline = detail::after(rtos_get_time_ns(), Seconds_to_nsecs(timeout));
    while (const std::uint32_t busy = state_->session)
        if (!detail::futexWait(state_->session, busy, deadline)) return state_->session == 0;
    return true;
}

void Thread::emergencyStop() {
    state_->running = false;
    // If the thread is not active any more, a stop() in another thread waits for this session and does the rest.
    if (state_->change(State::kActive, State::kStopping)) finalizeToIdle();
}

bool Thread::initialize() { return true; }
void Thread::step() {}
void Thread::loop() { step(); }
bool Thread::breakLoop() { return false; }
void Thread::finalize() {}

}  // namespace RTT::os
