// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_TIMER_COMPONENT_HPP
#define ORO_OCL_TIMER_COMPONENT_HPP

#include <ocl/OCL.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/Timer.hpp>
#include <rtt/rtt-config.h>

#include <memory>
#include <string>

namespace OCL {

/**
 * Timers that write their number to ports when they expire: each to the port `timeout`, and the first 32 also to the
 * port `timer_<number>`. They run from start() to stop().
 */
class OCL_API TimerComponent : public RTT::TaskContext {
public:
    explicit TimerComponent(std::string name = "os::Timer");
    ~TimerComponent() override;

protected:
    bool startHook() override;
    void stopHook() override;

private:
    bool wait(RTT::os::Timer::TimerId timer, double delay);

    class PortTimer;
    const std::unique_ptr<PortTimer> timer_;
    const std::unique_ptr<RTT::base::ActivityInterface> thread_;
};

}  // namespace OCL

#endif
