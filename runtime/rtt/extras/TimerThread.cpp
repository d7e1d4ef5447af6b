// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/TimerThread.hpp>

#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/futex.hpp>
#include <rtt/os/os_log.hpp>

#include <boost/weak_ptr.hpp>

#include <algorithm>
#include <mutex>

namespace RTT::extras {

namespace {

// How long a cycle waits for an activity that another thread executes before it skips it.
constexpr nsecs kLongExecution = 1000000000;

/** The parameters by which threads are shared. */
struct Parameters {
    int scheduler, priority;
    nsecs period;
    unsigned cpuAffinity;

    /** Adjusts the priority as CheckPriority() does, but without the limits of this user. */
    static Parameters of(int scheduler, int priority, nsecs period, unsigned cpuAffinity) {
        const bool realTime = scheduler != ORO_SCHED_OTHER;
        return {scheduler, realTime ? std::clamp(priority, os::LowestPriority, os::HighestPriority) : 0, period,
                cpuAffinity};
    }
    static Parameters of(const TimerThread& thread) {
        return of(thread.getScheduler(), thread.getPriority(), thread.getPeriodNS(), thread.getCpuAffinity());
    }
    bool operator==(const Parameters& other) const {
        return scheduler == other.scheduler && priority == other.priority && period == other.period &&
               cpuAffinity == other.cpuAffinity;
    }
};

struct Shared {
    Parameters asked, got;
    boost::weak_ptr<TimerThread> thread;

    /** The parameters as requested, because without the privilege the thread got others; later changes are included. */
    Parameters present(const TimerThread& one) const {
        const Parameters now = Parameters::of(one);
        Parameters result = asked;
        if (now.scheduler != got.scheduler || now.priority != got.priority) {
            result.scheduler = now.scheduler;
            result.priority = now.priority;
        }
        if (now.period != got.period) result.period = now.period;
        if (now.cpuAffinity != got.cpuAffinity) result.cpuAffinity = now.cpuAffinity;
        return result;
    }
};

struct Registry {
    std::mutex mutex;
    std::vector<Shared> shared;
};

Registry& registry() {
    static Registry& instance = *new Registry;  // never destroyed: static activities may come and go later
    return instance;
}

}  // namespace

TimerThread::TimerThread(int priority, const std::string& name, double period, unsigned cpuAffinity)
    : TimerThread(ORO_SCHED_RT, priority, name, period, cpuAffinity) {}

TimerThread::TimerThread(int scheduler, int priority, const std::string& name, double period, unsigned cpuAffinity)
    : os::Thread(scheduler, priority, period, cpuAffinity, name) {
    activities_.reserve(MAX_ACTIVITIES);  // step() must not allocate, and the vector must not move while it iterates
}

TimerThread::~TimerThread() {
    stop();
    terminate();
}

TimerThreadPtr TimerThread::Instance(int priority, double period) {
    return Instance(ORO_SCHED_RT, priority, period, 0);
}

TimerThreadPtr TimerThread::Instance(int scheduler, int priority, double period, unsigned cpuAffinity) {
    Registry& threads = registry();
    std::vector<TimerThreadPtr> others;  // released after the lock, because the last reference ends a thread
    std::lock_guard<std::mutex> lock(threads.mutex);
    const Parameters asked = Parameters::of(scheduler, priority, Seconds_to_nsecs(period), cpuAffinity);
    for (const Shared& entry : threads.shared) {
        TimerThreadPtr thread = entry.thread.lock();
        if (thread && entry.present(*thread) == asked) return thread;
        others.push_back(std::move(thread));
    }
    threads.shared.erase(std::remove_if(threads.shared.begin(), threads.shared.end(),
                                        [](const Shared& entry) { return entry.thread.expired(); }),
                         threads.shared.end());
    TimerThreadPtr thread(new TimerThread(scheduler, priority, "TimerThreadInstance", period, cpuAffinity));
    threads.shared.push_back(Shared{asked, Parameters::of(*thread), thread});
    return thread;
}

bool TimerThread::addActivity(PeriodicActivity* activity) {
    os::MutexLock lock(mutex_);
    if (activities_.size() < MAX_ACTIVITIES) {
        activities_.push_back(activity);
        return true;
    }
    // An activity that was removed during the cycle has left a gap.
    const auto gap = std::find(activities_.begin(), activities_.end(), nullptr);
    if (gap != activities_.end()) {
        *gap = activity;
        return true;
    }
    os::detail::log(os::detail::LogError, "TimerThread",
                    "cannot add an activity: the thread executes " + std::to_string(MAX_ACTIVITIES) + " already");
    return false;
}

bool TimerThread::removeActivity(PeriodicActivity* activity, nsecs deadline) {
    os::MutexLock lock(mutex_);
    const int self = os::detail::currentTid();
    while (activity->executor_ != 0 && activity->executor_ != self) {
        if (deadline == InfiniteNSecs)
            left_.wait(mutex_);
        else if (!left_.wait_until(mutex_, deadline))
            return false;
    }
    const auto at = std::find(activities_.begin(), activities_.end(), activity);
    if (at == activities_.end()) return true;
    if (inCycle_)
        *at = nullptr;  // the cycle is iterating and closes the gap at its end
    else
        activities_.erase(at);
    return true;
}

bool TimerThread::initialize() { return true; }

void TimerThread::step() {
    cycling_ = os::detail::currentTid();
    std::size_t count = 0;
    {
        os::MutexLock lock(mutex_);
        inCycle_ = true;
        count = activities_.size();  // activities that are started now wait for the next period
    }
    for (std::size_t i = 0; i < count; ++i)
        if (PeriodicActivity* const activity = enter(i)) {
            activity->executePeriod();
            leave(*activity);
        }
    os::MutexLock lock(mutex_);
    inCycle_ = false;
    activities_.erase(std::remove(activities_.begin(), activities_.end(), nullptr), activities_.end());
    cycling_ = 0;
}

// Enters the activity at that place; null if there is none, or if another thread does not leave it.
PeriodicActivity* TimerThread::enter(std::size_t index) {
    os::MutexLock lock(mutex_);
    const nsecs deadline = rtos_get_time_ns() + kLongExecution;
    while (PeriodicActivity* const activity = activities_[index]) {
        if (!activity->running_) return nullptr;
        if (enterNow(*activity)) return activity;
        if (activity->executor_ == os::detail::currentTid() || !left_.wait_until(mutex_, deadline)) return nullptr;
    }
    return nullptr;
}

// Without the mutex: leave() wakes the threads that wait for the end of an execution.
bool TimerThread::enterNow(PeriodicActivity& activity) {
    int nobody = 0;
    return activity.executor_.compare_exchange_strong(nobody, os::detail::currentTid());
}

void TimerThread::leave(PeriodicActivity& activity) {
    os::MutexLock lock(mutex_);
    activity.executor_ = 0;
    left_.broadcast();
}

bool TimerThread::executeNow(PeriodicActivity& activity) {
    {
        os::MutexLock lock(mutex_);
        if (!activity.running_ || !enterNow(activity)) return false;
    }
    activity.executePeriod();
    leave(activity);
    return true;
}

bool TimerThread::startForActivity() { return isActive() || start() || isActive(); }
bool TimerThread::isSelf() const { return os::Thread::isSelf() || cycling_ == os::detail::currentTid(); }

void TimerThread::finalize() {}

}  // namespace RTT::extras
