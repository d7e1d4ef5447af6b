// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// DATA, LOCKED and UNSYNC: one sample and its status. A Locked one holds its mutex while it assigns a sample.
#include <rtt/internal/flow/sample_box.hpp>
#include <rtt/internal/flow/detail/stores.hpp>
#include <rtt/internal/flow/detail/store_lock.hpp>

namespace RTT::internal::detail {

namespace {

template <class Mutex>
class PlainData final : public SampleStore {
public:
    PlainData(const types::TypeOps& ops, const void* first) : SampleStore(ops), sample_(ops, 1, first) {}

    WriteStatus write(const void* sample) override {
        const Hold<Mutex> hold(mutex_);
        assignSample(ops_, sample_.sample(0), sample);
        status_ = NewData;
        return WriteSuccess;
    }
    FlowStatus read(void* sample, bool copyOld) override {
        const Hold<Mutex> hold(mutex_);
        const FlowStatus status = status_;
        if (status == NewData || (status == OldData && copyOld)) assignSample(ops_, sample, sample_.sample(0));
        if (status == NewData) status_ = OldData;
        return status;
    }
    void clear() override {
        const Hold<Mutex> hold(mutex_);
        status_ = NoData;
    }
    std::size_t size() const override {
        const Hold<Mutex> hold(mutex_);
        return status_ == NewData ? 1 : 0;
    }

private:
    void resizeElements(const void* sample, bool) override {
        const Hold<Mutex> hold(mutex_);
        if (status_ == NoData) assignSample(ops_, sample_.sample(0), sample);
    }

    mutable Mutex mutex_;
    FlowStatus status_ = NoData;
    SampleArray sample_;
};

}  // namespace

StorePtr makePlainData(const types::TypeOps& ops, const StoreSpec& spec, const void* first) {
    if (spec.lock == StoreSpec::Locked) return StorePtr(new PlainData<StoreMutex>(ops, first));
    return StorePtr(new PlainData<NoMutex>(ops, first));
}

}  // namespace RTT::internal::detail
