// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCLOCK_SIM_CLOCK_THREAD_H
#define RTT_ROSCLOCK_SIM_CLOCK_THREAD_H

#include <rtt/Activity.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/os/TimeService.hpp>

#include <ros/time.h>

#include <boost/shared_ptr.hpp>

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>

namespace rtt_rosclock {

class ClockTopic;
class SimClockActivityManager;

/// The thread "rtt_rosclock_SimClockThread", which moves simulated time and executes all SimClockActivities. It runs from
/// its first use on, because it serves the messages of their components at any time. The functions of rtt_rosclock.h call
/// those of the same purpose here and document them. Any thread may call them.
class SimClockThread : public RTT::Activity {
public:
    enum ClockSource { SIM_CLOCK_SOURCE_MANUAL, SIM_CLOCK_SOURCE_ROS_CLOCK_TOPIC };

    /// The only one of this process, started.
    static boost::shared_ptr<SimClockThread> Instance();
    ~SimClockThread() override;

    bool setClockSource(ClockSource source);
    bool useROSClockTopic();
    bool useManualClock();
    ClockSource getClockSource() const;
    bool enableSim();
    bool disableSim();
    /// Real-time safe.
    static bool simTimeEnabled();
    bool updateClock(const ros::Time& time);

protected:
    bool initialize() override;
    void loop() override;
    bool breakLoop() override;
    /// Those that wait for a new time return false.
    void finalize() override;
    void work(RTT::base::RunnableInterface::WorkReason reason) override;

private:
    struct Update {
        RTT::nsecs time;
        bool* executed;  // of the thread that waits; null for none
        std::uint32_t ticket;
    };
    SimClockThread();
    void push(RTT::nsecs time, bool* executed);
    void dropUpdates();
    bool nextUpdate(Update& update, std::uint32_t& session);
    void finished(const Update& update, bool reached);
    bool advance(RTT::nsecs to, std::uint32_t session);
    bool moveBack(RTT::nsecs to, std::uint32_t session);
    void warnOfSkips(RTT::nsecs from, RTT::nsecs to);
    bool moveTime(RTT::nsecs to, std::uint32_t session);
    void executeDue(RTT::nsecs now, bool isClockTime, std::uint32_t session);
    void settle();
    void pollTopic();

    const boost::shared_ptr<SimClockActivityManager> manager_;
    RTT::ExecutionEngine engine_;  // takes the triggers of the activities

    mutable std::mutex mutex_;  // of what follows; never held while an activity executes
    ClockSource source_ = SIM_CLOCK_SOURCE_MANUAL;
    bool enabled_ = false;
    bool takesUpdates_ = false;  // the thread is not stopped
    std::atomic<std::uint32_t> session_{0};  // written with the mutex; counts enableSim() and disableSim()
    std::deque<Update> updates_;
    std::uint32_t asked_ = 0;  // number of updates ever made
    RTT::os::TimeService::ticks logReference_ = 0;
    std::shared_ptr<ClockTopic> topic_;
    std::atomic<std::uint32_t> done_{0};  // number of updates executed or dropped
    // Of this thread.
    std::uint32_t startedSession_ = 0;
    bool isFirst_ = true;  // no time since the last reset
    bool hasWarned_ = false;  // of skips, and no step without one has followed
};

}  // namespace rtt_rosclock

#endif
