// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCLOCK_SIM_CLOCK_ACTIVITY_H
#define RTT_ROSCLOCK_SIM_CLOCK_ACTIVITY_H

#include <rtt/extras/SlaveActivity.hpp>

#include <boost/shared_ptr.hpp>

#include <atomic>
#include <string>

namespace rtt_rosclock {

class SimClockActivityManager;
class SimClockThread;

/// A periodic activity in simulated time. The thread of the simulation executes step() and work(TimeOut) at each multiple
/// of the period, in order of creation among those that are due at the same time; with period 0, at each new time of the
/// clock. An execution sees its due time as the time of RTT::os::TimeService. Messages and port events are served in the
/// same thread between executions, also while the simulated time stands still or is not enabled.
///
/// Any thread may create, start, stop and destroy activities, also within the execution of another one. An activity may
/// stop itself in its own execution; only a component may destroy itself there.
class SimClockActivity : public RTT::extras::SlaveActivity {
public:
    explicit SimClockActivity(RTT::base::RunnableInterface* run = nullptr, const std::string& name = "SimClockActivity");
    /// In seconds; what is not positive is 0.
    explicit SimClockActivity(RTT::Seconds period, RTT::base::RunnableInterface* run = nullptr,
                              const std::string& name = "SimClockActivity");
    ~SimClockActivity() override;

    /// The first execution is at the next multiple of the period.
    bool start() override;
    bool isRunning() const override;
    RTT::Seconds getPeriod() const override;
    /// Any period of 0 or more. Real-time safe.
    bool setPeriod(RTT::Seconds period) override;
    bool isPeriodic() const override;
    /// False: only the thread of the simulation executes it.
    bool execute() override;
    /// Serves messages and port events soon. False if not active. Real-time safe.
    bool trigger() override;
    /// False: it executes only when due.
    bool timeout() override;
    virtual const std::string& getName() const;

protected:
    void loop() override;
    /// Logs an exception of the runnable, and stops.
    void work(RTT::base::RunnableInterface::WorkReason reason) override;

private:
    friend class SimClockActivityManager;
    SimClockActivity(const boost::shared_ptr<SimClockThread>& thread, RTT::Seconds period,
                     RTT::base::RunnableInterface* run, const std::string& name);
    bool isDue(RTT::nsecs now, bool isClockTime, bool isStep) const;
    RTT::nsecs nextDueAfter(RTT::nsecs now, RTT::nsecs limit) const;
    RTT::nsecs missed(RTT::nsecs now, RTT::nsecs until) const;
    void executeAt(RTT::nsecs now);
    template <class Function>
    void stopIfThrown(Function&& function);

    const boost::shared_ptr<SimClockThread> thread_;
    const boost::shared_ptr<SimClockActivityManager> manager_;
    const std::string name_;
    std::atomic<RTT::nsecs> period_;
    std::atomic<RTT::nsecs> last_{0};          // what was due up to this time has been executed
    std::atomic<bool> missedTrigger_{false};  // the thread had no room for it
    bool skips_ = false;                      // in this step; of the thread of the simulation
};

}  // namespace rtt_rosclock

#endif
