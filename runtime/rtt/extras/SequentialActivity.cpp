// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/SequentialActivity.hpp>

#include <rtt/internal/engine/try_flag.hpp>
#include <rtt/os/MainThread.hpp>
#include <rtt/os/futex.hpp>
#include <rtt/os/os_log.hpp>

#include <exception>

namespace RTT::extras {

SequentialActivity::SequentialActivity(base::RunnableInterface* r) { adopt(r); }

SequentialActivity::~SequentialActivity() {
    closeGate();
    stop();
    if (!isExecutor())
        waitForExecution(os::detail::kForever);  // an execution that stopped itself or has not ended in time
}

bool SequentialActivity::start() {
    {
        const internal::TryFlag mine(changing_);
        if (!mine || active_) return false;
        internal::ActiveWhile active(active_);
        if (!initialize()) return false;
        active.stay();
        open_ = true;
    }
    // Messages that came while it was stopped were not executed.
    if (runner && runner->hasWork()) trigger();
    return true;
}

bool SequentialActivity::stop() {
    const internal::TryFlag mine(changing_);
    const bool stops = mine && open_.exchange(false);
    // Even if it is not active, because callers of stop() expect that it is not executed afterwards.
    const bool left = isExecutor() || waitForExecution(rtos_get_time_ns() + Seconds_to_nsecs(1.0));
    if (!stops) return false;
    if (!left) {
        open_ = true;
        return false;
    }
    const internal::ActiveWhile active(active_);
    finalize();
    return true;
}

bool SequentialActivity::waitForExecution(nsecs deadline) {
    std::uint32_t requests = requests_;
    while (requests != 0) {
        // The mark asks the executing thread for a wake-up, so that it need not access this object afterwards.
        if (!(requests & kWaiting) && !requests_.compare_exchange_weak(requests, requests | kWaiting)) continue;
        const bool inTime = os::detail::futexWait(requests_, requests | kWaiting, deadline);
        requests = requests_;
        if (!inTime && requests != 0) return false;
    }
    return true;
}

bool SequentialActivity::isRunning() const { return requests_ != 0; }
bool SequentialActivity::isActive() const { return active_; }
os::ThreadInterface* SequentialActivity::thread() { return os::MainThread::Instance(); }
bool SequentialActivity::isExecutor() const { return executor_ == os::detail::currentTid(); }
bool SequentialActivity::isSelf() const {
    return isExecutor() || (!active_ && requests_ == 0 && os::MainThread::Instance()->isSelf());
}

bool SequentialActivity::trigger() {
    if (!open_) return false;
    // The caller that raises the count from 0 executes. Acquire and release: what the previous executor wrote to the
    // component is visible to this one, and what a refused caller queued is visible to the executor. Sequentially
    // consistent: this one and stop() each write one of (requests_, open_) and read the other one then; at least
    // one of them must see what the other has done, or the component would execute while it is being stopped.
    if (requests_.fetch_add(1) == 0) executeWhileWork();
    return true;
}

void SequentialActivity::executeWhileWork() {
    executor_ = os::detail::currentTid();
    try {
        executeOnce();
        finishWork();
    } catch (...) {
        free();
        throw;
    }
}

void SequentialActivity::finishWork() {
    // A caller may queue a message and be refused just after hasWork() returned false: then the count has moved on.
    std::uint32_t seen = requests_.load(std::memory_order_acquire);
    do {
        while (open_ && runner && runner->hasWork()) executeOnce();
    } while (!leave(seen));
}

// The next trigger must find the activity free.
void SequentialActivity::free() {
    std::uint32_t seen = requests_;
    while (!leave(seen)) {
    }
}

// Lets other threads execute if the word still is `seen`; otherwise updates `seen` and keeps the right to execute.
bool SequentialActivity::leave(std::uint32_t& seen) {
    executor_ = 0;  // before the count: the next executor puts itself here
    const std::uint32_t before = seen;
    if (!requests_.compare_exchange_strong(seen, 0)) {
        executor_ = os::detail::currentTid();
        return false;
    }
    if (before & kWaiting) os::detail::futexWakeAll(requests_);
    return true;
}

void SequentialActivity::executeOnce() {
    if (!open_) return;
    step();
    work(base::RunnableInterface::TimeOut);
}

base::ActivityInterface::Direct SequentialActivity::beginDirect() {
    return isSelf() ? SequentialActivity::beginInStead() : Direct::Refused;
}

// As a trigger while no thread executes, but executes the call of the caller.
base::ActivityInterface::Direct SequentialActivity::beginInStead() {
    if (isExecutor()) return Direct::Granted;
    std::uint32_t nobody = 0;
    if (!requests_.compare_exchange_strong(nobody, 1)) return Direct::Refused;
    executor_ = os::detail::currentTid();
    return Direct::Entered;
}

void SequentialActivity::endDirect() {
    // Called by a destructor; the call is unrelated to triggers of other threads.
    try {
        // Other threads have left their triggers to this one.
        if ((requests_ & ~kWaiting) > 1) executeOnce();
        return finishWork();
    } catch (const std::exception& e) {
        os::detail::log(os::detail::LogError, "SequentialActivity",
                        std::string("what others triggered meanwhile threw: ") + e.what());
    } catch (...) {
        os::detail::log(os::detail::LogError, "SequentialActivity", "what others triggered meanwhile threw");
    }
    free();
}

bool SequentialActivity::initialize() { return claimRunner() && (!runner || runner->initialize()); }

void SequentialActivity::step() {
    if (runner) runner->step();
}

void SequentialActivity::work(base::RunnableInterface::WorkReason reason) {
    if (runner) runner->work(reason);
}

void SequentialActivity::finalize() {
    if (runner) runner->finalize();
}

}  // namespace RTT::extras
