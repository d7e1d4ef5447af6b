// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_TIMER_THREAD_HPP
#define ORO_EXTRAS_TIMER_THREAD_HPP

#include <rtt/os/Condition.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/os/Thread.hpp>

#include <boost/shared_ptr.hpp>

#include <atomic>
#include <vector>

namespace RTT {
namespace extras {

class PeriodicActivity;
class TimerThread;
typedef boost::shared_ptr<TimerThread> TimerThreadPtr;

/** A periodic thread that executes PeriodicActivities one after another, in the order in which they were started. */
class RTT_API TimerThread : public os::Thread {
public:
    /** The most activities that one thread can execute. */
    static constexpr std::size_t MAX_ACTIVITIES = 64;

    TimerThread(int priority, const std::string& name, double period, unsigned cpuAffinity = 0);
    TimerThread(int scheduler, int priority, const std::string& name, double period, unsigned cpuAffinity = 0);
    ~TimerThread() override;

    /** The shared thread with these parameters, as requested or changed since; created if there is none. It lives as
        long as it is referred to. */
    static TimerThreadPtr Instance(int priority, double period);
    static TimerThreadPtr Instance(int scheduler, int priority, double period, unsigned cpuAffinity = 0);

    /** Executes an activity from the next period on. Logs an error and returns false if there are too many. */
    bool addActivity(PeriodicActivity* activity);
    /**
     * Removes an activity. Waits until no other thread executes it; if that lasts until the monotonic time `deadline`,
     * returns false and changes nothing.
     */
    bool removeActivity(PeriodicActivity* activity, nsecs deadline = InfiniteNSecs);
    /** Executes a started activity in the calling thread, not within a cycle. False if it is not started or
        executing. */
    bool executeNow(PeriodicActivity& activity);
    /** Enters an activity, started or not, in the calling thread, until leave(). False if another thread has entered. A
        cycle waits for it. Never blocks; real-time safe. */
    bool enterNow(PeriodicActivity& activity);
    void leave(PeriodicActivity& activity);
    /** Starts the thread for an activity. */
    virtual bool startForActivity();
    /** True also in another thread that executes cycles of this one. */
    bool isSelf() const override;

protected:
    bool initialize() override;
    void step() override;
    void finalize() override;

private:
    PeriodicActivity* enter(std::size_t index);

    // Never held while an activity is executed: activities of several threads may stop each other.
    os::Mutex mutex_;
    os::Condition left_;                         // an activity has returned
    std::vector<PeriodicActivity*> activities_;  // null: removed during the cycle
    bool inCycle_ = false;
    std::atomic<int> cycling_{0};  // Linux id of the thread that executes a cycle; 0 for none
};

}  // namespace extras
}  // namespace RTT
#endif
