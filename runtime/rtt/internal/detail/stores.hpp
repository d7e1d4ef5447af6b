// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The implementations behind SampleStore::make().
#ifndef ORO_INTERNAL_DETAIL_STORES_HPP
#define ORO_INTERNAL_DETAIL_STORES_HPP

#include <rtt/internal/SampleStore.hpp>
#include <rtt/types/TypeOps.hpp>

#include <memory>

namespace RTT {
namespace internal {
namespace detail {

typedef std::unique_ptr<SampleStore> StorePtr;

/** Whether makeVersionedData() can store the type. */
bool fitsVersionedData(const types::TypeOps& ops);
StorePtr makeVersionedData(const types::TypeOps& ops, const StoreSpec& spec);
StorePtr makeCountedData(const types::TypeOps& ops, const StoreSpec& spec, const void* first);
StorePtr makePlainData(const types::TypeOps& ops, const StoreSpec& spec, const void* first);
StorePtr makeLockFreeBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first);
/** Whether makeWordBuffer() can store the type. */
bool fitsWordBuffer(const types::TypeOps& ops, const StoreSpec& spec);
StorePtr makeWordBuffer(const types::TypeOps& ops, const StoreSpec& spec);
StorePtr makePlainBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first);

/** Runs a function at the end of the scope, even if assigning a sample throws. */
template <class F>
class AtEnd {
public:
    explicit AtEnd(F f) : f_(f) {}
    ~AtEnd() { f_(); }
    AtEnd(const AtEnd&) = delete;
    AtEnd& operator=(const AtEnd&) = delete;

private:
    F f_;
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
