// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service `sim_clock_activity` of a component: loading it gives the component a SimClockActivity.
#include <rtt_rosclock/rtt_rosclock.h>

#include <rtt/plugin/ServicePlugin.hpp>

#include <string>

namespace rtt_rosclock {

namespace {

class SimClockActivityService : public RTT::Service {
public:
    explicit SimClockActivityService(RTT::TaskContext* owner) : RTT::Service("sim_clock_activity", owner) {
        doc("The component executes in simulated time since this service was loaded.");
    }
};

}  // namespace

}  // namespace rtt_rosclock

ORO_PLUGIN_C_LINKAGE_BEGIN_
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component);
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {
    if (!component) return true;
    if (!rtt_rosclock::set_sim_clock_activity(component)) return false;
    return component->provides()->hasService("sim_clock_activity") ||
           component->provides()->addService(
               RTT::Service::shared_ptr(new rtt_rosclock::SimClockActivityService(component)));
}
RTT_EXPORT std::string getRTTPluginName();
RTT_EXPORT std::string getRTTPluginName() { return "sim_clock_activity"; }
RTT_EXPORT std::string getRTTTargetName();
RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
ORO_PLUGIN_C_LINKAGE_END_
