// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ACTIONLIB_STATUS_TIMER_HPP
#define RTT_ACTIONLIB_STATUS_TIMER_HPP

#include <ros/time.h>
#include <rtt/Activity.hpp>

#include <atomic>
#include <functional>
#include <string>

namespace RTT {
namespace base {
class PortInterface;
}
}  // namespace RTT

namespace rtt_actionlib {

/** The present time of ROS, also in a process that is no node yet. Any thread. */
ros::Time now();

/** A thread of lowest priority that calls a function at regular intervals. */
class StatusTimer : public RTT::Activity {
public:
    /** A period that is not positive becomes 0.2 s. */
    StatusTimer(const std::string& name, RTT::Seconds period, int scheduler, std::function<void()> tick);
    ~StatusTimer() override;

protected:
    void step() override;

private:
    const std::function<void()> tick_;
};

/** Finds samples that came while a component was not running, which nobody told it of. */
class MissedSamples {
public:
    /** If the component was started since the last call, has it look at these ports. One thread. */
    void tellOnce(RTT::base::PortInterface& first, RTT::base::PortInterface& second);

private:
    bool wasRunning_ = false;
};

}  // namespace rtt_actionlib

#endif
