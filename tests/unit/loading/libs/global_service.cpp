// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/plugin/ServicePlugin.hpp>

class GlobalCounting : public RTT::Service {
public:
    explicit GlobalCounting(RTT::TaskContext* owner) : RTT::Service("globalcounting", owner) {}
};

ORO_GLOBAL_SERVICE_NAMED_PLUGIN(GlobalCounting, "globalcounting")
