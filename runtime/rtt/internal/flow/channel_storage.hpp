// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The channel element that stores samples: all there is between two local ports.
#ifndef ORO_INTERNAL_CHANNEL_STORAGE_HPP
#define ORO_INTERNAL_CHANNEL_STORAGE_HPP

#include <rtt/base/ChannelElement.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/internal/flow/storage_core.hpp>

namespace RTT {
namespace internal {

/** Typed only because transports look for a ChannelElement<T> next to them. write() and read() are real-time safe. */
template <typename T>
class ChannelStorage final : public base::ChannelElement<T> {
public:
    typedef base::ChannelElementBase Base;
    typedef typename Base::shared_ptr BasePtr;
    typedef typename base::ChannelElement<T>::param_t param_t;
    typedef typename base::ChannelElement<T>::reference_t reference_t;

    /** `first`, which may be null, shows the size of samples. */
    [[gnu::cold]] ChannelStorage(const ConnPolicy& policy, const void* first)
        : core_(types::typeOps<T>(), policy, first) {}
    /** Null, with an error logged, if the policy is not valid. */
    [[gnu::cold, gnu::noinline]] static BasePtr make(const ConnPolicy& policy) {
        return StorageCore::heldIfReady(new ChannelStorage<T>(policy, nullptr));
    }

    WriteStatus write(param_t sample) override { return StorageCore::writeTyped(*this, &sample); }
    FlowStatus read(reference_t sample, bool copyOld) override { return core_.store().read(&sample, copyOld); }
    using base::ChannelElement<T>::data_sample;
    [[gnu::cold]] WriteStatus data_sample(param_t sample, bool reset) override {
        return ChannelStorage::sampleErased(&sample, reset);
    }

    WriteStatus writeErased(const void* sample) override { return core_.write(sample, *this); }
    FlowStatus readErased(void* sample, bool copyOld) override { return core_.store().read(sample, copyOld); }
    [[gnu::cold]] WriteStatus sampleErased(const void* sample, bool reset) override {
        core_.store().setSample(sample, reset);
        return Base::sampleErased(sample, reset);
    }
    [[gnu::cold]] bool getSampleErased(void* sample) override { return core_.store().getSample(sample); }

    [[gnu::cold]] void clear() override { core_.store().clear(); }
    bool signal() override { return core_.hasManyReaders() ? core_.signalReaders() : Base::signal(); }
    [[gnu::cold]] bool connectTo(BasePtr const& output, bool mandatory = true) override {
        return core_.connect(*this, output, mandatory);
    }
    [[gnu::cold]] const ConnPolicy* getConnPolicy() const override { return &core_.policy(); }
    [[gnu::cold]] std::string getElementName() const override { return StorageCore::elementName(); }

    StorageCore& core() { return core_; }
    StorageCore* storageCore() override { return &core_; }

private:
    StorageCore core_;
};

}  // namespace internal
}  // namespace RTT

#endif
