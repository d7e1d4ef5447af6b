// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_TIMER_THREAD_HPP
#define ORO_EXTRAS_TIMER_THREAD_HPP

#include <rtt/os/Mutex.hpp>
#include <rtt/os/Thread.hpp>

#include <boost/shared_ptr.hpp>

#include <vector>

namespace RTT {
namespace extras {

class PeriodicActivity;
class TimerThread;
typedef boost::shared_ptr<TimerThread> TimerThreadPtr;

/** A periodic thread that executes PeriodicActivities one after another, in the order in which they were started. */
class RTT_API TimerThread : public os::Thread {
public:
    /** Activities that one thread can execute. */
    static constexpr std::size_t MaxActivities = 64;

    TimerThread(int priority, const std::string& name, double period, unsigned cpuAffinity = 0);
    TimerThread(int scheduler, int priority, const std::string& name, double period, unsigned cpuAffinity = 0);
    ~TimerThread() override;

    /** The shared thread with these parameters; created if there is none. It lives as long as somebody holds it. */
    static TimerThreadPtr Instance(int priority, double period);
    static TimerThreadPtr Instance(int scheduler, int priority, double period, unsigned cpuAffinity = 0);

    /** Starts executing an activity with the next period. False if it holds MaxActivities already. */
    bool addActivity(PeriodicActivity* activity);
    /** When this returns, the activity is not executed any more, unless the caller is the activity itself. */
    bool removeActivity(PeriodicActivity* activity);

protected:
    bool initialize() override;
    void step() override;
    void finalize() override;

private:
    os::MutexRecursive mutex_;                   // recursive: activities start and stop each other while they execute
    std::vector<PeriodicActivity*> activities_;  // null: removed during the cycle
    bool inCycle_ = false;
};

}  // namespace extras
}  // namespace RTT
#endif
