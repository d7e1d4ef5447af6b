// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/sample_store.hpp>

#include <rtt/internal/flow/detail/stores.hpp>
#include <rtt/internal/flow/sample_box.hpp>

namespace RTT::internal {

SampleStore::~SampleStore() = default;

std::unique_ptr<SampleStore> SampleStore::make(const types::TypeOps& ops, const StoreSpec& spec, const void* first) {
    if (!first && !ops.construct) return nullptr;
    const bool data = spec.kind == StoreSpec::Data;
    if (spec.lock != StoreSpec::LockFree)
        return data ? detail::makePlainData(ops, spec, first) : detail::makePlainBuffer(ops, spec, first);
    if (!data)
        return detail::fitsWordBuffer(ops, spec) ? detail::makeWordBuffer(ops, spec)
                                                 : detail::makeLockFreeBuffer(ops, spec, first);
    return detail::fitsVersionedData(ops) ? detail::makeVersionedData(ops, spec)
                                          : detail::makeCountedData(ops, spec, first);
}

void SampleStore::setSample(const void* sample, bool reset) {
    const bool larger = noteExtent(extentOf(sample));
    if (!reset && !larger && std::atomic_load(&prototype_)) return;
    std::atomic_store(&prototype_, std::shared_ptr<const SampleBox>(std::make_shared<SampleBox>(ops_, sample)));
    if (reset) clear();
    resizeElements(sample, true);
}

bool SampleStore::noteExtent(std::size_t extent) {
    std::size_t largest = largest_.load(std::memory_order_relaxed);
    while (extent > largest)
        if (largest_.compare_exchange_weak(largest, extent, std::memory_order_relaxed)) return true;
    return false;
}

void SampleStore::grow(const void* sample, std::size_t extent) {
    if (!noteExtent(extent)) return;
    try {
        resizeElements(sample, false);
    } catch (...) {
        // The sample is written. An element that could not be sized reports its error when a sample is assigned to it.
    }
}

bool SampleStore::getSample(void* sample) const {
    const std::shared_ptr<const SampleBox> prototype = std::atomic_load(&prototype_);
    if (!prototype) return false;
    assignSample(ops_, sample, prototype->get());
    return true;
}

}  // namespace RTT::internal
