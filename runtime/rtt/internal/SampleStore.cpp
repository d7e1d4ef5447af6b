// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/SampleStore.hpp>

#include <rtt/internal/SampleBox.hpp>
#include <rtt/internal/detail/stores.hpp>

namespace RTT {
namespace internal {

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
    if (!reset && std::atomic_load(&prototype_)) return;
    std::atomic_store(&prototype_, std::shared_ptr<const SampleBox>(std::make_shared<SampleBox>(ops_, sample)));
    if (reset) clear();
    resizeElements(sample);
}

bool SampleStore::getSample(void* sample) const {
    const std::shared_ptr<const SampleBox> prototype = std::atomic_load(&prototype_);
    if (!prototype) return false;
    assignSample(ops_, sample, prototype->get());
    return true;
}

}  // namespace internal
}  // namespace RTT
