// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A plugin written by hand: its own declarations, no target, nothing that tells its version.
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>

extern "C" {
RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {
    if (!component) return true;
    if (component->getName() == "unwelcome") return false;
    component->provides("byhand")->addConstant("answer", 42);
    return true;
}
RTT_EXPORT std::string getRTTPluginName() { return "byhand"; }
RTT_EXPORT RTT::Service::shared_ptr createService() { return RTT::Service::shared_ptr(new RTT::Service("byhand")); }
}
