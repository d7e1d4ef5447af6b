// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service `ros.clock` of the process.
#include <rtt_rosclock/rtt_rosclock.h>

#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt/types/Types.hpp>

#include <string>

namespace rtt_rosclock {

namespace {

class RosClockService : public RTT::Service {
public:
    explicit RosClockService(RTT::TaskContext* owner) : RTT::Service("clock", owner) {
        doc("Time of ROS and of this runtime, and simulated time.");
        addOperation("host_now", &host_now)
            .doc("Simulated time while it is enabled, otherwise the time of ROS, or of the system without ROS.");
        addOperation("host_wall_now", &host_wall_now).doc("The time of the system, simulated or not.");
        addOperation("rtt_now", &rtt_now).doc("Simulated time while it is enabled, otherwise the monotonic clock.");
        addOperation("rtt_wall_now", &rtt_wall_now).doc("The monotonic clock, simulated or not.");
        addOperation("host_offset_from_rtt", &host_offset_from_rtt)
            .doc("The difference of host_wall_now() and rtt_wall_now(). [s]");
        addOperation("setSimClockActivity", &set_sim_clock_activity)
            .doc("Lets a component execute in simulated time, with its present period. False if it is running.")
            .arg("component", "the component");
        addOperation("useROSClockTopic", &use_ros_clock_topic)
            .doc("Takes simulated time from the topic /clock. False while it is enabled.");
        addOperation("useManualClock", &use_manual_clock)
            .doc("Takes simulated time from updateSimClock(). False while it is enabled.");
        for (const char* const name : {"enableSim", "enableSimClock"})
            addOperation(name, &enable_sim)
                .doc(
                    "Begins simulated time, at 0. False if /clock is the source, and there is no ROS node or the parameter "
                    "/use_sim_time is not true.");
        for (const char* const name : {"disableSim", "disableSimClock"})
            addOperation(name, &disable_sim).doc("Ends simulated time.");
        addOperation("setCatchUpLimit", &set_catch_up_limit)
            .doc(
                "How often an activity may be due in one step of the clock and executes each time. One that is due more often "
                "executes once, at the end of the step. False if negative.")
            .arg("executions", "the limit, 1000 at first");
        addOperation("catchUpLimit", &catch_up_limit).doc("What setCatchUpLimit() has set.");
        addOperation("updateSimClock", &update_sim_clock)
            .doc("The new time of the manual clock. Returns when all that is due up to then has been executed.")
            .arg("time", "the time, not the difference");
    }
};

}  // namespace

}  // namespace rtt_rosclock

ORO_PLUGIN_C_LINKAGE_BEGIN_
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component);
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {
    if (component) return false;
    // Scripts get and give values of the type `time`.
    if (!RTT::types::Types()->type("time")) RTT::plugin::PluginLoader::Instance()->loadTypekit("rtt_ros");
    const RTT::Service::shared_ptr ros = RTT::internal::GlobalService::Instance()->provides("ros");
    return ros->hasService("clock") ||
           ros->addService(RTT::Service::shared_ptr(new rtt_rosclock::RosClockService(nullptr)));
}
RTT_EXPORT std::string getRTTPluginName();
RTT_EXPORT std::string getRTTPluginName() { return "rosclock"; }
RTT_EXPORT std::string getRTTTargetName();
RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
ORO_PLUGIN_C_LINKAGE_END_
