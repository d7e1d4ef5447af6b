// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/plugin/ServicePlugin.hpp>

#include <stdexcept>

class CountingService : public RTT::Service {
public:
    explicit CountingService(RTT::TaskContext* owner) : RTT::Service("counting", owner) {
        if (owner && owner->getName() == "unlucky") throw std::runtime_error("13 is not supported");
        addOperation("next", &CountingService::next, this).doc("Counts");
    }

private:
    int next() { return ++count_; }

    int count_ = 0;
};

ORO_SERVICE_NAMED_PLUGIN(CountingService, "counting")
