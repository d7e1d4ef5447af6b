// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a buffer of several parts needs of each of them.
#ifndef ORO_INTERNAL_DETAIL_BUFFER_PART_HPP
#define ORO_INTERNAL_DETAIL_BUFFER_PART_HPP

#include <rtt/internal/flow/sample_store.hpp>

#include <cstdint>
#include <memory>

namespace RTT {
namespace internal {
namespace detail {

/** A buffer whose samples have stamps, by which the oldest one of several buffers is found. */
class BufferPart : public SampleStore {
public:
    typedef std::uint64_t Stamp;
    struct Oldest {
        std::uint64_t position;
        Stamp stamp;
    };

    /** As write(), but does not count what is refused. */
    virtual bool tryWrite(const void* sample, Stamp stamp) = 0;
    /** Finds the sample that read() would take; false if there is none. Sets the position in either case. */
    virtual bool oldest(Oldest& found) const = 0;
    /** Takes it; false if another reader has taken it meanwhile. */
    virtual bool takeOldest(const Oldest& known, void* sample) = 0;
    /** How many samples were taken out so far: the position of the oldest one. */
    virtual std::uint64_t takenOut() const = 0;
    /** True only if it was full at one moment. */
    virtual bool full() const = 0;
    /** How many samples were entered so far; an estimate. */
    virtual std::uint64_t entered() const = 0;
    /** The flow status of the sample that was read last, or -1 if another reader interfered. */
    virtual int readOld(void* sample, bool copyOld) = 0;

    void resizeElements(const void* sample, bool all) override = 0;

protected:
    using SampleStore::SampleStore;
};

/** A buffer with LockFree as its policy; see buffer_lock_free.cpp. */
std::unique_ptr<BufferPart> makeBufferPart(const types::TypeOps& ops, const StoreSpec& spec, const void* first);

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
