// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/SequentialActivity.hpp>

#include <rtt/internal/TryFlag.hpp>
#include <rtt/os/MainThread.hpp>
#include <rtt/os/detail/futex.hpp>

namespace RTT {
namespace extras {

SequentialActivity::SequentialActivity(base::RunnableInterface* r) { adopt(r); }

SequentialActivity::~SequentialActivity() {
    closeGate();
    stop();
    if (!isSelf()) waitForExecution(os::detail::kForever);  // one that stopped itself, or does not end in time
}

bool SequentialActivity::start() {
    {
        const internal::TryFlag mine(changing_);
        if (!mine || active_ || !claimRunner() || (runner && !runner->initialize())) return false;
        active_ = true;
        open_ = true;
    }
    // Messages that came while it was stopped have found nobody to execute them.
    if (runner && runner->hasWork()) trigger();
    return true;
}

bool SequentialActivity::stop() {
    const internal::TryFlag mine(changing_);
    const bool stops = mine && open_.exchange(false);
    // Also if it is not active: who calls stop() does not expect that it is still being executed.
    const bool left = isSelf() || waitForExecution(rtos_get_time_ns() + Seconds_to_nsecs(1.0));
    if (!stops) return false;
    if (!left) {
        open_ = true;
        return false;
    }
    active_ = false;
    if (runner) runner->finalize();
    return true;
}

bool SequentialActivity::waitForExecution(nsecs deadline) {
    std::uint32_t requests = requests_;
    while (requests != 0) {
        // The mark asks the executing thread for a wake-up, which then need not look at this object afterwards.
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
bool SequentialActivity::isSelf() const { return executor_ == os::detail::currentTid(); }

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
        // A caller may queue a message and be refused just after hasWork() returned false: then the count has moved on.
        std::uint32_t seen = requests_.load(std::memory_order_acquire);
        do {
            while (open_ && runner && runner->hasWork()) executeOnce();
        } while (!leave(seen));
    } catch (...) {
        // The next trigger must find the activity free.
        std::uint32_t seen = requests_;
        while (!leave(seen)) {
        }
        throw;
    }
}

// Lets others execute if the word still is `seen`; otherwise updates `seen` and keeps the right to execute.
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
    if (!open_ || !runner) return;
    runner->step();
    runner->work(base::RunnableInterface::TimeOut);
}

}  // namespace extras
}  // namespace RTT
