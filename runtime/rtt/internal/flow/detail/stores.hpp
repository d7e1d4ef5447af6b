// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The implementations behind SampleStore::make().
#ifndef ORO_INTERNAL_DETAIL_STORES_HPP
#define ORO_INTERNAL_DETAIL_STORES_HPP

#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/types/TypeOps.hpp>

#include <memory>

namespace RTT {
namespace internal {
namespace detail {

typedef std::unique_ptr<SampleStore> StorePtr;

// Data keeps the newest sample, a buffer a queue. `first`, which may be null, is the sample that all elements copy at
// first; plain samples need none, because they all have one size.

/** LockFree, small plain samples: a reader copies words and then checks that their version did not change. */
StorePtr makeVersionedData(const types::TypeOps& ops, const StoreSpec& spec);
bool fitsVersionedData(const types::TypeOps& ops);
/** LockFree, other samples: a slot counts the threads that read it, and is not reused meanwhile. */
StorePtr makeCountedData(const types::TypeOps& ops, const StoreSpec& spec, const void* first);
/** Locked: with a mutex. Unsync: without, for one thread at a time. */
StorePtr makePlainData(const types::TypeOps& ops, const StoreSpec& spec, const void* first);

/** LockFree, small plain samples of a buffer that is not too long: samples are words, as in makeVersionedData(). */
StorePtr makeWordBuffer(const types::TypeOps& ops, const StoreSpec& spec);
bool fitsWordBuffer(const types::TypeOps& ops, const StoreSpec& spec);
/** LockFree, other samples. */
StorePtr makeLockFreeBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first);
/** LockFree and not circular, other samples, many writers: with a part for each processor, see buffer_parted.cpp. */
StorePtr makePartedBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first);
/** Locked or Unsync, as makePlainData(). */
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
