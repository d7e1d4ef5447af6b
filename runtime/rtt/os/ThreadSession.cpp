// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/detail/thread_state.hpp>
#include <rtt/os/os_log.hpp>

#include <cxxabi.h>
#include <exception>

/** @file What the thread itself executes. */
namespace RTT::os {

void Thread::run() {
    while (!state_->exit) {
        if (state_->session & State::kDue)
            runOneSession();
        else  // start() sets kDue before it wakes the thread, so kDue is visible after this
            state_->earlyReasons |= waitForWake(detail::kForever);
    }
}

void Thread::runOneSession() {
    state_->session = State::kRunning;  // only start() sets kDue again
    std::string failure;
    try {
        if (mayRun()) session();
    } catch (abi::__forced_unwind&) {
        throw;  // the thread is being cancelled: that must go on
    } catch (const std::exception& e) {
        failure = e.what();
        if (failure.empty()) failure = "std::exception";
    } catch (...) {
        failure = "an exception of unknown type";
    }
    if (!failure.empty()) {
        detail::log(detail::LogCritical, "Thread",
                    "thread '" + state_->name + "' stopped by an uncaught C++ exception: " + failure);
        emergencyStop();
    }
    state_->session.fetch_and(~static_cast<std::uint32_t>(State::kRunning));
    detail::futexWakeAll(state_->session);
}

void Thread::session() {
    if (getPeriodNS() == 0) {
        UserCode mark(*this);
        if (mayRun()) loop();
        return;
    }
    nsecs wakeUp = rtos_get_time_ns();
    while (mayRun()) {
        const nsecs next = nextWakeUp(wakeUp, rtos_get_time_ns(), getPeriodNS());
        if (next == 0) return;
        step();
        while (mayRun() && rtos_get_time_ns() < next) waitForWake(next);
        wakeUp = next;
    }
}

// Sequentially consistent, as the mark of UserCode is. The thread sets the mark and then calls this; stop() clears
// `running` and then looks at the mark. So either stop() sees the mark and breaks the loop, or this sees that no user
// code may begin.
bool Thread::mayRun() const noexcept { return state_->running.load(); }

void Thread::wake(std::uint32_t reasons) noexcept { state_->wakeWord.post(reasons); }

std::uint32_t Thread::waitForWake(nsecs deadline) noexcept { return state_->wakeWord.wait(deadline); }

std::uint32_t Thread::takeEarlyReasons() noexcept {
    const std::uint32_t reasons = state_->earlyReasons;
    state_->earlyReasons = 0;
    return reasons & ~(kFirstOwnReason - 1);
}

nsecs Thread::nextWakeUp(nsecs previous, nsecs now, nsecs period) {
    const nsecs next = detail::after(state_->waitPolicy == ORO_WAIT_REL ? now : previous, period);
    // An overrun is being late by a whole period: with ORO_WAIT_REL the next wake-up is never in the past, even if
    // periods were missed.
    if (detail::after(previous, period) > now) {
        if (state_->overruns > 0) --state_->overruns;
        return next;
    }
    const int most = state_->maxOverrun;
    if (++state_->overruns < most || most < 0) return next;
    const std::string count = std::to_string(state_->overruns);
    state_->overruns = 0;
    detail::log(detail::LogCritical, "Thread",
                "thread '" + state_->name + "' stopped: it has missed its period " + count + " times too often");
    detail::log(detail::LogCritical, "Thread", "see Thread::setMaxOverrun() to allow more");
    emergencyStop();
    return 0;
}

Thread::UserCode::UserCode(Thread& thread) noexcept : thread_(thread) { ++thread_.state_->inUserCode; }
Thread::UserCode::~UserCode() { --thread_.state_->inUserCode; }

}  // namespace RTT::os
