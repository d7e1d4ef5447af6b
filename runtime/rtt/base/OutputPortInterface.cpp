// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/OutputPortInterface.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/flow/channel_array.hpp>
#include <rtt/internal/flow/port_endpoint.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/internal/flow/sample_box.hpp>
#include <rtt/internal/flow/storage_core.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <cstring>

namespace RTT::base {

using internal::ChannelArray;
using internal::Reclaimer;
using internal::SampleBox;
using internal::SampleStore;

OutputPortInterface::OutputPortInterface(const std::string& name, const types::TypeOps* ops, bool keep_last)
    : PortInterface(name, ops) {
    keepLastWrittenValue(keep_last);
}

OutputPortInterface::~OutputPortInterface() {
    closeDown();
    delete last_.load(std::memory_order_relaxed);
}

/** The channels that one write() found broken. Releases them even if assigning a sample throws. */
class OutputPortInterface::DeadChannels {
public:
    DeadChannels() {}  // leaves the list uninitialised: writes without broken channels do not touch it
    ~DeadChannels() {
        for (std::size_t i = 0; i < count_; ++i) list_[i]->deref();
    }
    DeadChannels(const DeadChannels&) = delete;
    DeadChannels& operator=(const DeadChannels&) = delete;

    void add(ChannelElementBase* channel) {
        if (count_ == kMax) return;  // the next write finds it again
        channel->ref();
        list_[count_++] = channel;
    }
    bool empty() const { return count_ == 0; }
    ChannelElementBase* const* begin() const { return list_; }
    ChannelElementBase* const* end() const { return list_ + count_; }

private:
    static constexpr std::size_t kMax = 8;
    std::size_t count_ = 0;
    ChannelElementBase* list_[kMax];
};

// The flags are relaxed: one that changes while other threads write applies to later writes. Its storage orders the
// kept value; the release of its publication in allocateLast() and the acquire loads of last_ order the storage itself.
WriteStatus OutputPortInterface::writeSample(const void* sample) {
    if (keep_last_.load(std::memory_order_relaxed) || keep_next_.load(std::memory_order_relaxed))
        remember(sample);
    else if (has_last_.load(std::memory_order_relaxed))
        has_last_.store(false, std::memory_order_relaxed);

    {
        const Reclaimer::Guard guard;
        const ChannelArray* channels = channels_.load(std::memory_order_acquire);
        if (!channels) return NotConnected;
        if (__builtin_expect(channels->size == 1, 1)) {
            const ChannelArray::Entry& only = *channels->begin();
            const WriteStatus status = only.write(sample);
            if (__builtin_expect(status == WriteSuccess, 1)) return WriteSuccess;
            if (status != NotConnected) return only.mandatory ? status : WriteSuccess;
        }
    }
    // A function of its own: its list would cost the usual write, above, a check of the stack.
    const auto toAll = [ this, sample ]() __attribute__((noinline)) {
        DeadChannels dead;
        WriteStatus worst;
        {
            const Reclaimer::Guard guard;
            const ChannelArray* channels = channels_.load(std::memory_order_acquire);
            if (!channels) return NotConnected;
            worst = writeToAll(*channels, sample, dead);
        }
        return __builtin_expect(dead.empty(), 1) ? worst : dropDead(dead, worst);
    };
    return toAll();
}

/** For several channels, or a broken one. */
inline WriteStatus OutputPortInterface::writeToAll(const ChannelArray& channels, const void* sample,
                                                   DeadChannels& dead) {
    WriteStatus worst = WriteSuccess;
    for (const ChannelArray::Entry& entry : channels) {
        const WriteStatus status = entry.write(sample);
        if (__builtin_expect(status == WriteSuccess, 1)) continue;
        if (status == NotConnected) dead.add(entry.channel);
        if (entry.mandatory && status > worst) worst = status;
    }
    return worst;
}

void OutputPortInterface::remember(const void* sample) {
    SampleStore* const last = last_.load(std::memory_order_acquire);
    if (!last) return;
    keep_next_.store(false, std::memory_order_relaxed);
    // Fails only if more threads write at once than the storage allows; another thread's value is then the last.
    if (last->write(sample) == WriteSuccess) has_last_.store(true, std::memory_order_release);
}

/** Removes channels whose other end is gone. */
WriteStatus OutputPortInterface::dropDead(const DeadChannels& dead, WriteStatus worst) {
    for (ChannelElementBase* channel : dead) getManager()->removeChannel(channel);
    if (connected()) return worst;
    log(Error) << "output port " << getFullName()
               << ": its last channel was found broken during write() and has been removed" << endlog();
    return NotConnected;
}

bool OutputPortInterface::copyLastWritten(void* sample) const {
    SampleStore* const last = last_.load(std::memory_order_acquire);
    return last && has_last_.load(std::memory_order_acquire) && last->read(sample, true) != NoData;
}

void OutputPortInterface::setSample(const void* sample) {
    std::atomic_store(&initial_, std::shared_ptr<const SampleBox>(std::make_shared<SampleBox>(*sampleOps(), sample)));
    has_last_.store(false, std::memory_order_release);
    if (SampleStore* last = last_.load(std::memory_order_acquire)) last->setSample(sample, true);
    for (const internal::ConnectionManager::ChannelDescriptor& c : getManager()->getConnections())
        (void)c.get<1>()->sampleErased(sample, true);
}

void OutputPortInterface::allocateLast() {
    if (last_.load(std::memory_order_acquire) || !sampleOps()) return;
    const std::shared_ptr<const SampleBox> initial = std::atomic_load(&initial_);
    std::unique_ptr<SampleStore> made =
        SampleStore::make(*sampleOps(), internal::StoreSpec(), initial ? initial->get() : nullptr);
    SampleStore* none = nullptr;
    if (last_.compare_exchange_strong(none, made.get(), std::memory_order_acq_rel)) made.release();
}

void OutputPortInterface::keepLastWrittenValue(bool keep) {
    if (keep) allocateLast();
    keep_last_.store(keep, std::memory_order_relaxed);
}

void OutputPortInterface::keepNextWrittenValue(bool keep) {
    if (keep) allocateLast();
    keep_next_.store(keep, std::memory_order_relaxed);
}

void OutputPortInterface::clear() {
    has_last_.store(false, std::memory_order_release);
    const Reclaimer::Guard guard;
    const ChannelArray* channels = channels_.load(std::memory_order_acquire);
    if (!channels) return;
    for (const ChannelArray::Entry& entry : *channels) {
        internal::StorageCore* core = entry.channel->storageCore();
        if (core && core->hasManyReaders()) entry.channel->clear();
    }
}

bool OutputPortInterface::initialise(ChannelElementBase& channel, bool init) {
    const types::TypeOps* ops = sampleOps();
    const std::shared_ptr<const SampleBox> initial = std::atomic_load(&initial_);
    if (!ops || (!initial && !ops->construct)) return true;  // nothing to size it with
    internal::SampleArray sample(*ops, 1, initial ? initial->get() : nullptr);
    // The sample of setDataSample() takes precedence over the last value, which may be smaller.
    bool has_last = !initial && copyLastWritten(sample.sample(0));
    // A default value is useless for local storage, which consists of default values until the first sample sizes it.
    const bool tells = initial || has_last || !channel.storageCore();
    if (tells && channel.sampleErased(sample.sample(0), false) != WriteSuccess) {
        log(Error) << "output port " << getFullName()
                   << ": could not pass a data sample to the new channel, giving up the connection" << endlog();
        return false;
    }
    if (init && initial) has_last = copyLastWritten(sample.sample(0));
    // A failure to write now (a buffer of size 0) will show at the next write, too.
    if (!init || !has_last) return true;
    const Reclaimer::Guard guard;
    return channel.writeErased(sample.sample(0)) != NotConnected;
}

WriteStatus OutputPortInterface::write(DataSourceBase::shared_ptr source) {
    const std::type_info* const type = source ? source->getTypeId() : nullptr;
    const bool fits = type && sampleOps() && std::strcmp(type->name(), sampleOps()->id->name()) == 0;
    const void* const sample = fits && source->evaluate() ? source->getRawConstPointer() : nullptr;
    if (sample) return writeSample(sample);
    log(Error) << "port " << getFullName() << ": trying to write from an incompatible data source: found "
               << (source ? source->getType() : std::string("none")) << ", expected "
               << (getTypeInfo() ? getTypeInfo()->getTypeName() : std::string("value")) << endlog();
    return WriteFailure;
}

bool OutputPortInterface::createConnection(InputPortInterface& sink, ConnPolicy const& policy) {
    return internal::ConnFactory::createConnection(*this, sink, policy);
}

bool OutputPortInterface::createConnection(InputPortInterface& sink) {
    return createConnection(sink, sink.getDefaultPolicy());
}

bool OutputPortInterface::createDataConnection(InputPortInterface& sink, int lock_policy) {
    return createConnection(sink, ConnPolicy::data(lock_policy));
}

bool OutputPortInterface::createBufferConnection(InputPortInterface& sink, int size, int lock_policy) {
    return createConnection(sink, ConnPolicy::buffer(size, lock_policy));
}

bool OutputPortInterface::createConnection(internal::SharedConnectionBase::shared_ptr shared_connection,
                                           ConnPolicy const& policy) {
    return internal::ConnFactory::createSharedConnection(this, nullptr, shared_connection, policy);
}

namespace {
/** Null, and an error, if it is no input port. */
InputPortInterface* inputFor(const OutputPortInterface& output, PortInterface* other) {
    InputPortInterface* const input = other ? other->asInput() : nullptr;
    if (!input)
        log(Error) << "output port " << output.getFullName() << " could not connect to "
                   << (other ? other->getFullName() : std::string("nothing")) << ": not an input port" << endlog();
    return input;
}
}  // namespace

bool OutputPortInterface::connectTo(PortInterface* other, ConnPolicy const& policy) {
    InputPortInterface* const input = inputFor(*this, other);
    return input && createConnection(*input, policy);
}

bool OutputPortInterface::connectTo(PortInterface* other) {
    InputPortInterface* const input = inputFor(*this, other);
    return input && createConnection(*input);
}

bool OutputPortInterface::createStream(ConnPolicy const& policy) {
    return internal::ConnFactory::createStream(*this, policy);
}

bool OutputPortInterface::addConnection(internal::ConnID* id, ChannelElementBase::shared_ptr channel,
                                        ConnPolicy const& policy) {
    if (!id || !channel) return PortInterface::addConnection(id, channel, policy);
    channel->connectFrom(ChannelElementBase::shared_ptr(getEndpoint()));
    if (initialise(*channel, policy.init)) return PortInterface::addConnection(id, channel, policy);
    delete id;
    return false;
}

}  // namespace RTT::base
