// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Implements the buffer classes by the storage that connections use.
#ifndef ORO_INTERNAL_STORED_BUFFER_HPP
#define ORO_INTERNAL_STORED_BUFFER_HPP

#include <rtt/base/BufferInterface.hpp>
#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/types/TypeOps.hpp>

#include <memory>

namespace RTT {
namespace internal {

/** Push() and Pop() of one sample are as real-time safe as the assignment of a T and the lock policy. */
template <class T>
class StoredBuffer : public base::BufferInterface<T> {
public:
    typedef typename base::BufferInterface<T>::value_t value_t;
    typedef typename base::BufferInterface<T>::reference_t reference_t;
    typedef typename base::BufferInterface<T>::param_t param_t;
    typedef typename base::BufferInterface<T>::size_type size_type;

    bool Push(param_t item) override { return store_->write(&item) == WriteSuccess; }
    size_type Push(const std::vector<value_t>& items) override {
        size_type taken = 0;
        for (value_t item : items) {  // a copy: elements of vector<bool> have no address
            if (!Push(item)) break;
            ++taken;
        }
        return taken;
    }
    // A store without new samples gives OldData, but a loop over Pop() ends at 0, which is NoData.
    FlowStatus Pop(reference_t item) override { return store_->read(&item, false) == NewData ? NewData : NoData; }
    size_type Pop(std::vector<value_t>& items) override {
        items.clear();
        for (value_t item = data_sample(); store_->read(&item, false) == NewData;) items.push_back(item);
        return static_cast<size_type>(items.size());
    }
    value_t* PopWithoutRelease() override { return static_cast<value_t*>(const_cast<void*>(store_->readHeld())); }
    void Release(value_t* item) override {
        if (item) store_->release(item);
    }
    bool data_sample(param_t sample, bool reset = true) override {
        store_->setSample(&sample, reset);
        return true;
    }
    value_t data_sample() const override {
        value_t value = value_t();
        store_->getSample(&value);
        return value;
    }

    size_type capacity() const override { return static_cast<size_type>(store_->capacity()); }
    size_type size() const override { return static_cast<size_type>(store_->size()); }
    bool empty() const override { return store_->size() == 0; }
    bool full() const override { return store_->size() >= store_->capacity(); }
    void clear() override { store_->clear(); }
    size_type dropped() const override { return static_cast<size_type>(store_->dropped()); }

protected:
    StoredBuffer(StoreSpec::Lock lock, unsigned int size, const T* initial, const base::BufferBase::Options& options) {
        StoreSpec spec;
        spec.kind = options.circular() ? StoreSpec::CircularBuffer : StoreSpec::Buffer;
        spec.lock = lock;
        spec.size = size;
        spec.maxThreads = options.max_threads();
        spec.held = true;
        store_ = SampleStore::make(types::typeOps<T>(), spec, initial);
        if (initial) store_->setSample(initial, true);
    }

private:
    std::unique_ptr<SampleStore> store_;
};

}  // namespace internal
}  // namespace RTT

#endif
