// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/port_sources.hpp>

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/internal/flow/sample_store.hpp>

namespace RTT::internal {

PortLink::PortLink(const base::PortInterface& port)
    : endpoint_(port.getEndpoint()), input_(port.asInput() != nullptr) {}
PortLink::PortLink(const PortLink&) = default;
PortLink::~PortLink() = default;

// The port's destructor waits while this thread is within the Guard.
FlowStatus PortLink::read(void* sample) const {
    const Reclaimer::Guard guard;
    auto* const port = static_cast<base::InputPortInterface*>(endpoint_->getPort());
    return port ? port->readSample(sample, true) : NoData;
}

WriteStatus PortLink::write(const void* sample) const {
    const Reclaimer::Guard guard;
    auto* const port = static_cast<base::OutputPortInterface*>(endpoint_->getPort());
    return port ? port->writeSample(sample) : NotConnected;
}

bool PortLink::last(void* sample) const {
    const Reclaimer::Guard guard;
    auto* const port = static_cast<base::OutputPortInterface*>(endpoint_->getPort());
    return port && port->copyLastWritten(sample);
}

bool PortLink::newest(void* sample, std::uint64_t& seen) const {
    const Reclaimer::Guard guard;
    auto* const port = static_cast<base::OutputPortInterface*>(endpoint_->getPort());
    const SampleStore* const store = port ? port->last_.load(std::memory_order_acquire) : nullptr;
    if (!store) return false;
    std::uint64_t number = store->newest();
    if (number == seen || number == 0) return false;
    // The number must be that of the value that was read, or the newest one would be taken for another one later.
    constexpr int kTries = 4;  // against a port that writes all the time
    for (int i = 0; i != kTries; ++i) {
        if (!port->copyLastWritten(sample)) return false;
        const std::uint64_t now = store->newest();
        if (now == number) break;
        number = now;
    }
    seen = number;
    return true;
}

bool PortLink::keepsLast() const {
    const Reclaimer::Guard guard;
    const auto* const port = static_cast<base::OutputPortInterface*>(endpoint_->getPort());
    return port && port->keepsLastWrittenValue();
}

bool PortLink::fetch(void* sample) const { return input_ ? read(sample) != NoData : last(sample); }

PortPlace::PortPlace(const PortLink& link, base::DataSourceBase* value, void (*reset)(void*), bool orDefault)
    : ValuePlace(value), link_(link), at_(value->getRawPointer()), reset_(reset), or_default_(orDefault) {}

bool PortPlace::evaluate() const {
    if (link_.fetch(at_)) return true;
    if (or_default_) reset_(at_);
    return or_default_;
}

void* PortPlace::value() const { return at_; }

void* PortPlace::get() const {
    evaluate();
    return at_;
}

void* PortPlace::forChange() { return at_; }

void* PortPlace::raw() { return nullptr; }

void PortPlace::assign(const void*) {}

void PortPlace::updated() {}

bool PortPlace::isAssignable() const { return false; }

bool PortPlace::isFixed() const { return true; }

bool PortPlace::isPart() const { return false; }

ValuePlace* PortPlace::clone() const { return new PortPlace(link_, parent->clone(), reset_, or_default_); }

ValuePlace* PortPlace::copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const { return nullptr; }

}  // namespace RTT::internal
