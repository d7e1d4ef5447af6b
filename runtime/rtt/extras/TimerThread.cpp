// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/TimerThread.hpp>

#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/detail/os_log.hpp>

#include <boost/weak_ptr.hpp>

#include <algorithm>
#include <mutex>

namespace RTT {
namespace extras {

namespace {

struct Shared {
    int scheduler, priority;
    nsecs period;
    unsigned cpuAffinity;
    boost::weak_ptr<TimerThread> thread;

    bool has(int s, int p, nsecs ns, unsigned cpus) const {
        return scheduler == s && priority == p && period == ns && cpuAffinity == cpus;
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
    activities_.reserve(MaxActivities);  // step() must not allocate, nor must the vector move while it iterates
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
    std::lock_guard<std::mutex> lock(threads.mutex);
    // Compared as asked for: the thread itself may have got less, without the privilege.
    const nsecs ns = Seconds_to_nsecs(period);
    for (const Shared& entry : threads.shared)
        if (entry.has(scheduler, priority, ns, cpuAffinity))
            if (TimerThreadPtr thread = entry.thread.lock()) return thread;
    threads.shared.erase(std::remove_if(threads.shared.begin(), threads.shared.end(),
                                        [](const Shared& entry) { return entry.thread.expired(); }),
                         threads.shared.end());
    TimerThreadPtr thread(new TimerThread(scheduler, priority, "TimerThreadInstance", period, cpuAffinity));
    threads.shared.push_back(Shared{scheduler, priority, ns, cpuAffinity, thread});
    return thread;
}

bool TimerThread::addActivity(PeriodicActivity* activity) {
    os::MutexLock lock(mutex_);
    if (activities_.size() >= MaxActivities) {
        os::detail::log(os::detail::LogError, "TimerThread",
                        "cannot add an activity: the thread executes " + std::to_string(MaxActivities) + " already");
        return false;
    }
    activities_.push_back(activity);
    return true;
}

bool TimerThread::removeActivity(PeriodicActivity* activity) {
    os::MutexLock lock(mutex_);  // other threads wait for the end of the cycle here
    const auto at = std::find(activities_.begin(), activities_.end(), activity);
    if (at == activities_.end()) return false;
    if (inCycle_)
        *at = nullptr;  // the cycle iterates: it closes the gap at its end
    else
        activities_.erase(at);
    return true;
}

bool TimerThread::initialize() { return true; }

void TimerThread::step() {
    os::MutexLock lock(mutex_);
    inCycle_ = true;
    const std::size_t count = activities_.size();  // those that are started now wait for the next period
    for (std::size_t i = 0; i < count; ++i)
        if (activities_[i]) activities_[i]->executePeriod();
    inCycle_ = false;
    activities_.erase(std::remove(activities_.begin(), activities_.end(), nullptr), activities_.end());
}

void TimerThread::finalize() {}

}  // namespace extras
}  // namespace RTT
