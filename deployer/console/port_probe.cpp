// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "port_probe.hpp"

#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <chrono>
#include <utility>

namespace OCL::console {
namespace {

constexpr int kRoom = 1000;  // samples between two calls of read()

std::int64_t now() {
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

bool PortProbe::Meter::dataOnPortHook(RTT::base::PortInterface*) {
    const std::int64_t time = now(), before = last_.exchange(time);
    if (before == 0) first_ = time;
    const std::int64_t interval = time - before;
    if (before != 0 && interval >= 0) {  // two threads that write may get here in another order
        for (std::int64_t seen = shortest_; interval < seen && !shortest_.compare_exchange_weak(seen, interval);) {
        }
        for (std::int64_t seen = longest_; interval > seen && !longest_.compare_exchange_weak(seen, interval);) {
        }
    }
    ++samples_;
    return false;  // nobody waits for it
}

PortProbe::Intervals PortProbe::Meter::intervals() const {
    Intervals made;
    made.samples = samples_;
    made.first = first_;
    made.last = last_;
    made.shortest = shortest_;
    made.longest = longest_;
    return made;
}

std::unique_ptr<PortProbe> PortProbe::make(RTT::base::OutputPortInterface& port, From from, std::string& why) {
    const RTT::types::TypeInfo* const type = port.getTypeInfo();
    if (!port.isLocal() || !type || type == RTT::types::Types()->unknownType()) {
        why = port.isLocal() ? "no typekit that is loaded has its type" : "it is a port of another process";
        return nullptr;
    }
    RTT::base::DataSourceBase::shared_ptr value = type->buildValue();
    std::unique_ptr<RTT::base::PortInterface> clone(port.antiClone());
    auto* const input = clone ? clone->asInput() : nullptr;
    if (!value || !input) {
        why = "values of its type cannot be copied";
        return nullptr;
    }
    (void)clone.release();
    std::unique_ptr<PortProbe> probe(new PortProbe(std::move(value)));
    probe->port_.reset(input);
    probe->meter_.ports()->addEventPort(*input);
    RTT::ConnPolicy policy = RTT::ConnPolicy::circularBuffer(kRoom);
    policy.init = from == From::LastSample;
    if (port.createConnection(*input, policy)) return probe;
    why = "it takes no further connection; the log says why";
    return nullptr;
}

PortProbe::~PortProbe() {
    if (!port_) return;
    port_->disconnect();
    meter_.ports()->removePort(port_->getName());
}

std::uint64_t PortProbe::dropped() const { return RTT::internal::droppedSamples(*port_); }

}  // namespace OCL::console
