// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// BUFFER and CIRCULAR_BUFFER, LOCKED and UNSYNC: a ring with one place more than its capacity, which keeps the sample
// read last for readers of the empty buffer. A Locked one holds its mutex while it assigns a sample.
#include <rtt/internal/flow/sample_box.hpp>
#include <rtt/internal/flow/detail/stores.hpp>
#include <rtt/internal/flow/detail/store_lock.hpp>

#include <algorithm>
#include <vector>

namespace RTT::internal::detail {

namespace {

template <class Mutex>
class PlainBuffer final : public SampleStore {
public:
    PlainBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first)
        : SampleStore(ops),
          capacity_(spec.size),
          circular_(spec.kind == StoreSpec::CircularBuffer),
          oldData_(spec.oldData),
          places_(ops, spec.size + 1, first),
          held_(ops, spec.held ? std::max<std::size_t>(spec.maxThreads, 1) : 0, first),
          inUse_(held_.count(), false) {}

    WriteStatus write(const void* sample) override {
        const WriteStatus status = enter(sample);
        if (status == WriteSuccess) keepSized(sample, extentOf(sample));
        return status;
    }
    FlowStatus read(void* sample, bool copyOld) override {
        const Hold<Mutex> hold(mutex_);
        if (filled_ > 0) {
            assignSample(ops_, sample, places_.sample(first_));
            advance();
            hasLast_ = true;
            return NewData;
        }
        if (!oldData_ || !hasLast_) return NoData;
        if (copyOld) assignSample(ops_, sample, places_.sample(lastPlace()));
        return OldData;
    }
    void clear() override {
        const Hold<Mutex> hold(mutex_);
        filled_ = 0;
        hasLast_ = false;
    }
    const void* readHeld() override {
        const Hold<Mutex> hold(mutex_);
        if (filled_ == 0 || held_.count() == 0) return nullptr;
        void* const sample = held_.sample(placeToHold());
        assignSample(ops_, sample, places_.sample(first_));
        advance();
        hasLast_ = true;
        return sample;
    }
    void release(const void* held) override {
        const Hold<Mutex> hold(mutex_);
        for (std::size_t i = 0; i < held_.count(); ++i)
            if (held_.sample(i) == held) inUse_[i] = false;
    }

    std::size_t capacity() const override { return capacity_; }
    std::size_t size() const override {
        const Hold<Mutex> hold(mutex_);
        return filled_;
    }
    std::size_t dropped() const override {
        const Hold<Mutex> hold(mutex_);
        return dropped_;
    }

private:
    WriteStatus enter(const void* sample) {
        const Hold<Mutex> hold(mutex_);
        if (filled_ == capacity_) {
            ++dropped_;
            if (!circular_ || capacity_ == 0) return WriteFailure;
            // The oldest is dropped. The next write goes to the spare place, and overwrites the sample read last.
            advance();
            hasLast_ = false;
        }
        assignSample(ops_, places_.sample(place(filled_)), sample);
        ++filled_;
        return WriteSuccess;
    }
    /** A free place, or the next one in turn if there is none because a reader never releases. */
    std::size_t placeToHold() {
        for (std::size_t i = 0; i < held_.count(); ++i)
            if (!inUse_[i]) {
                inUse_[i] = true;
                return i;
            }
        inTurn_ = inTurn_ + 1 < held_.count() ? inTurn_ + 1 : 0;
        return inTurn_;
    }
    std::size_t place(std::size_t n) const { return (first_ + n) % places_.count(); }
    std::size_t lastPlace() const { return (first_ + places_.count() - 1) % places_.count(); }
    void advance() {
        first_ = place(1);
        --filled_;
    }
    void resizeElements(const void* sample, bool all) override {
        const Hold<Mutex> hold(mutex_);
        const std::size_t end = all ? places_.count() : std::min(kAtOnce, places_.count());
        for (std::size_t n = 0; n < end; ++n) {
            void* const target = places_.sample(place(n));
            if (n >= filled_ && !(hasLast_ && place(n) == lastPlace())) {
                assignSample(ops_, target, sample);
                continue;
            }
            const SampleBox kept(ops_, target);
            assignSample(ops_, target, sample);
            assignSample(ops_, target, kept.get());
        }
        for (std::size_t i = 0; i < held_.count(); ++i)
            if (!inUse_[i]) assignSample(ops_, held_.sample(i), sample);
    }

    mutable Mutex mutex_;
    const std::size_t capacity_;
    const bool circular_, oldData_;
    bool hasLast_ = false;  // the place before first_ holds the sample read last
    std::size_t first_ = 0, filled_ = 0, dropped_ = 0;
    SampleArray places_;
    SampleArray held_;  // copies of samples that readers hold
    std::vector<bool> inUse_;
    std::size_t inTurn_ = 0;
};

}  // namespace

StorePtr makePlainBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first) {
    if (spec.lock == StoreSpec::Locked) return StorePtr(new PlainBuffer<StoreMutex>(ops, spec, first));
    return StorePtr(new PlainBuffer<NoMutex>(ops, spec, first));
}

}  // namespace RTT::internal::detail
