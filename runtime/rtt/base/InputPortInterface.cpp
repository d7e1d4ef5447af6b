// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/InputPortInterface.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Service.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/channel_array.hpp>
#include <rtt/internal/flow/port_endpoint.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/internal/flow/storage_core.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <cstring>
#include <memory>

namespace RTT::base {

using internal::ChannelArray;
using internal::Reclaimer;

InputPortInterface::InputPortInterface(const std::string& name, const ConnPolicy& default_policy,
                                       const types::TypeOps* ops)
    : PortInterface(name, ops), default_policy_(default_policy) {
    endpoint().setInputPort(this);
}

InputPortInterface::~InputPortInterface() {
    closeDown();
    forgetSignals();
}

FlowStatus InputPortInterface::readSample(void* sample, bool copyOld) {
    const Reclaimer::Guard guard;
    const ChannelArray* channels = channels_.load(std::memory_order_acquire);
    if (!channels) return NoData;
    if (channels->size == 1) return channels->begin()->read(sample, copyOld);
    return readSeveral(*channels, sample, copyOld);
}

/** The channel that had the last new sample comes first and provides the old data. */
FlowStatus InputPortInterface::readSeveral(const ChannelArray& channels, void* sample, bool copyOld) {
    const ChannelElementBase* const current = current_.load(std::memory_order_relaxed);
    const ChannelArray::Entry* first = channels.begin();
    for (const ChannelArray::Entry& entry : channels)
        if (entry.channel == current) first = &entry;

    FlowStatus best = first->read(sample, copyOld);
    const ChannelArray::Entry* old = first;
    for (const ChannelArray::Entry& entry : channels) {
        if (best == NewData) break;
        if (&entry == first) continue;
        const FlowStatus status = entry.read(sample, false);
        if (status > best) {
            best = status;
            old = &entry;
        }
    }
    if (best == OldData && old != first && copyOld) best = old->read(sample, true);
    if (best == NewData) current_.store(old->channel, std::memory_order_relaxed);
    return best;
}

namespace {
/** The number of samples to read; a guess for elements that keep them elsewhere. */
std::size_t waiting(const ChannelArray* channels) {
    constexpr std::size_t kElsewhere = 128;
    std::size_t sum = 0;
    if (channels)
        for (const ChannelArray::Entry& entry : *channels) {
            const internal::StorageCore* const core = entry.channel->storageCore();
            sum += core ? core->store().size() : kElsewhere;
        }
    return sum;
}
}  // namespace

// Reads no more samples than there were at first: a writer faster than the reader would keep it here for ever.
FlowStatus InputPortInterface::readNewestSample(void* sample, bool copyOld) {
    const FlowStatus status = readSample(sample, copyOld);
    if (status != NewData) return status;
    const Reclaimer::Guard guard;
    for (std::size_t left = waiting(channels_.load(std::memory_order_acquire)); left > 0; --left)
        if (readSample(sample, false) != NewData) break;
    return NewData;
}

void InputPortInterface::clear() {
    const Reclaimer::Guard guard;
    if (const ChannelArray* channels = channels_.load(std::memory_order_acquire))
        for (const ChannelArray::Entry& entry : *channels) entry.channel->clear();
}

bool InputPortInterface::copyDataSample(void* sample) const {
    const Reclaimer::Guard guard;
    if (const ChannelArray* channels = channels_.load(std::memory_order_acquire))
        for (const ChannelArray::Entry& entry : *channels)
            if (entry.channel->getSampleErased(sample)) return true;
    return false;
}

FlowStatus InputPortInterface::read(DataSourceBase::shared_ptr source, bool copy_old_data) {
    const std::type_info* const type = source ? source->getTypeId() : nullptr;
    const bool fits = type && sampleOps() && std::strcmp(type->name(), sampleOps()->id->name()) == 0;
    void* const target = fits && source->isAssignable() ? source->getRawPointer() : nullptr;
    if (!target) {
        log(Error) << "port " << getFullName() << ": trying to read to an incompatible data source: found "
                   << (source ? source->getType() : std::string("none")) << ", expected an assignable "
                   << (getTypeInfo() ? getTypeInfo()->getTypeName() : std::string("value")) << endlog();
        return NoData;
    }
    const FlowStatus status = readSample(target, copy_old_data);
    if (status == NewData || (status == OldData && copy_old_data)) source->updated();
    return status;
}

bool InputPortInterface::connectTo(PortInterface* other, ConnPolicy const& policy) {
    OutputPortInterface* output = other ? other->asOutput() : nullptr;
    if (output) return output->createConnection(*this, policy);
    log(Error) << "input port " << getFullName() << " could not connect to "
               << (other ? other->getFullName() : std::string("nothing")) << ": not an output port" << endlog();
    return false;
}

bool InputPortInterface::connectTo(PortInterface* other) { return connectTo(other, getDefaultPolicy()); }

bool InputPortInterface::createStream(ConnPolicy const& policy) {
    return internal::ConnFactory::createStream(*this, policy);
}

bool InputPortInterface::createConnection(internal::SharedConnectionBase::shared_ptr shared_connection,
                                          ConnPolicy const& policy) {
    return internal::ConnFactory::createSharedConnection(nullptr, this, shared_connection, policy);
}

void InputPortInterface::addOperationsTo(Service& object) {
    PortInterface::addOperationsTo(object);
    object.addSynchronousOperation("clear", &InputPortInterface::clear, this).doc("Forgets all samples in the port.");
}

bool InputPortInterface::channelReady(ChannelElementBase::shared_ptr const& channel, ConnPolicy const& policy,
                                      internal::ConnID* id) {
    std::unique_ptr<internal::ConnID> owned(id);
    if (!channel || !channel->inputReady(ChannelElementBase::shared_ptr(getEndpoint()))) return false;
    if (!id) return true;
    return addConnection(owned.release(), channel, policy);
}

bool InputPortInterface::connectFrom(OutputPortInterface&, ConnPolicy const&) {
    log(Error) << "input port " << getFullName() << " lives in another process (protocol " << serverProtocol()
               << "), and no transport for its type "
               << (getTypeInfo() ? getTypeInfo()->getTypeName() : std::string("unknown_t")) << " is loaded" << endlog();
    return false;
}

}  // namespace RTT::base
