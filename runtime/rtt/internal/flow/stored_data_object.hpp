// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Implements the data object classes by the storage that connections use.
#ifndef ORO_INTERNAL_STORED_DATA_OBJECT_HPP
#define ORO_INTERNAL_STORED_DATA_OBJECT_HPP

#include <rtt/base/DataObjectInterface.hpp>
#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/types/TypeOps.hpp>

#include <memory>

namespace RTT {
namespace internal {

/** Get() and Set() are as real-time safe as the assignment of a T and the lock policy. */
template <class T>
class StoredDataObject : public base::DataObjectInterface<T> {
public:
    typedef typename base::DataObjectInterface<T>::value_t value_t;
    typedef typename base::DataObjectInterface<T>::reference_t reference_t;
    typedef typename base::DataObjectInterface<T>::param_t param_t;

    FlowStatus Get(reference_t pull, bool copy_old_data = true) const override {
        return store_->read(&pull, copy_old_data);
    }
    value_t Get() const override {
        value_t value = value_t();
        store_->read(&value, true);
        return value;
    }
    bool Set(param_t push) override { return store_->write(&push) == WriteSuccess; }
    bool data_sample(param_t sample, bool reset = true) override {
        store_->setSample(&sample, reset);
        return true;
    }
    value_t data_sample() const override {
        value_t value = value_t();
        store_->getSample(&value);
        return value;
    }
    void clear() override { store_->clear(); }

protected:
    StoredDataObject(StoreSpec::Lock lock, const T* initial, unsigned int max_threads) {
        StoreSpec spec;
        spec.lock = lock;
        spec.maxThreads = max_threads;
        store_ = SampleStore::make(types::typeOps<T>(), spec, initial);
        if (initial) store_->setSample(initial, true);
    }

private:
    std::unique_ptr<SampleStore> store_;
};

}  // namespace internal
}  // namespace RTT

#endif
