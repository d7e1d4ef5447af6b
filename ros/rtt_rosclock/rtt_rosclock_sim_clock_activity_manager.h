// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCLOCK_SIM_CLOCK_ACTIVITY_MANAGER_H
#define RTT_ROSCLOCK_SIM_CLOCK_ACTIVITY_MANAGER_H

#include <rtt/Time.hpp>
#include <rtt/internal/engine/access_gate.hpp>

#include <boost/shared_ptr.hpp>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace rtt_rosclock {

class SimClockActivity;

/// Knows all SimClockActivities and executes those that are due. SimClockThread does all of it; others only look.
class SimClockActivityManager {
public:
    /// What catchUpLimit() is at first.
    static constexpr int kCatchUpLimit = 1000;

    /// The only one of this process.
    static boost::shared_ptr<SimClockActivityManager> Instance();

    /// By how much the last step moved the time, in seconds. Any thread.
    RTT::Seconds getSimulationPeriod() const;
    void setSimulationPeriod(RTT::Seconds period);
    /// An activity that is due more often in a step of the clock executes once, at the end of the step. Any thread; 0 or
    /// more.
    int catchUpLimit() const { return static_cast<int>(catchUpLimit_); }
    void setCatchUpLimit(int executions) { catchUpLimit_ = executions; }
    /// Executes what is due at the present time of RTT::os::TimeService, in the calling thread and in order of creation,
    /// each activity at most once. For one thread at a time.
    /// \param isClockTime activities of period 0 execute as well
    void update(bool isClockTime = true);
    /// Due times are set anew: activities are next due after `now`.
    void reset(RTT::nsecs now);
    /// The time of the last execution or reset, in ns. Any thread.
    RTT::nsecs now() const { return now_; }

private:
    friend class SimClockActivity;
    friend class SimClockThread;
    struct Entry {
        SimClockActivity* activity;
        std::shared_ptr<RTT::internal::AccessGate> gate;
    };
    /// Which activities execute once in a step, because they are due too often.
    struct Skips {
        int activities = 0;
        RTT::nsecs most = 0;   // how often the busiest one of them is due
        std::string busiest;
    };
    // Of the thread of the simulation, in this order. nextDue() gives a time after now() and not after `end`, the end of
    // the step.
    void beginStep();
    RTT::nsecs nextDue(RTT::nsecs end);
    void execute(RTT::nsecs now, bool isClockTime, bool isStep, const std::function<bool()>& goesOn);
    const Skips& skips() const { return skips_; }

    void add(SimClockActivity& activity);
    void remove(SimClockActivity& activity);
    void noteMissedTrigger() { missedTriggers_ = true; }
    void repeatMissedTriggers();
    template <class Function>
    void forEach(Function&& function);

    std::mutex mutex_;  // never held while an activity executes
    std::vector<Entry> activities_;
    std::atomic<std::uint32_t> version_{0};  // of activities_
    std::vector<Entry> snapshot_;            // of the executing thread
    std::uint32_t snapshotVersion_ = 0;
    Skips skips_;                            // of the executing thread
    std::atomic<RTT::nsecs> period_{0}, now_{0}, catchUpLimit_{kCatchUpLimit};
    std::atomic<bool> missedTriggers_{false};
};

}  // namespace rtt_rosclock

#endif
