// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where samples wait between a writer and a reader: one interface, written once for all types over TypeOps.
//
//   kind             lock policy  small plain samples          all others
//   DATA             LOCK_FREE    detail/data_versioned.cpp    detail/data_counted.cpp
//   DATA             LOCKED/UNSYNC                 detail/data_plain.cpp
//   (CIRCULAR_)BUFFER LOCK_FREE   detail/buffer_words.cpp      detail/buffer_lock_free.cpp
//   (CIRCULAR_)BUFFER LOCKED/UNSYNC                detail/buffer_plain.cpp
#ifndef ORO_INTERNAL_SAMPLE_STORE_HPP
#define ORO_INTERNAL_SAMPLE_STORE_HPP

#include <rtt/FlowStatus.hpp>
#include <rtt/rtt-config.h>
#include <rtt/types/TypeOps.hpp>

#include <atomic>
#include <cstddef>
#include <memory>

namespace RTT {
namespace types {
struct TypeOps;
}
namespace internal {
class SampleBox;

/** What a storage is to be; the part of a ConnPolicy that matters here. */
struct StoreSpec {
    enum Kind { Data, Buffer, CircularBuffer };
    enum Lock { Unsync, Locked, LockFree };
    Kind kind = Data;
    Lock lock = LockFree;
    std::size_t size = 0;        ///< capacity of a buffer
    std::size_t maxThreads = 2;  ///< threads that use a lock-free storage at once
    bool oldData = true;         ///< an empty buffer gives its last sample again
    bool held = false;           ///< readHeld() will be used
};

/** Storage of samples. LockFree and Locked ones may be used by any number of threads in any role, Unsync ones by one
    thread at a time. write(), read() and clear() are real-time safe as far as assigning a sample is, except that Locked
    ones take a mutex; they allocate nothing themselves. A sample that is larger than all before, see types::SampleExtent,
    is also assigned to the elements that are free then, or to 64 of them, so that the next ones fit where they come to lie. */
class RTT_API SampleStore {
public:
    /** `first` (may be null) is what the preallocated samples are copied from. Null if the type cannot be default
        constructed and no first sample is given. */
    static std::unique_ptr<SampleStore> make(const types::TypeOps& ops, const StoreSpec& spec, const void* first);
    virtual ~SampleStore();
    SampleStore(const SampleStore&) = delete;
    SampleStore& operator=(const SampleStore&) = delete;

    /** Failure: a full buffer, or more threads at once than a lock-free storage was made for. */
    virtual WriteStatus write(const void* sample) = 0;
    virtual FlowStatus read(void* sample, bool copyOld) = 0;
    virtual void clear() = 0;

    /** Assigns `sample` to all free preallocated elements so that later assignments need not allocate. With `reset`
        forgets all samples; without, does nothing if there was a sizing sample before that was as large. May run while
        others use the storage. Not real-time safe. */
    void setSample(const void* sample, bool reset);
    /** The last sizing sample; false, and nothing copied, if there was none. Not real-time safe. */
    bool getSample(void* sample) const;

    virtual std::size_t capacity() const { return 1; }
    /** Samples not read yet; an estimate while others use the storage. */
    virtual std::size_t size() const = 0;
    /** Samples refused or thrown away because the buffer was full. */
    virtual std::size_t dropped() const { return 0; }

    /** The oldest sample, untouched until release(); null if none. At most one held per thread. For StoreSpec::held. */
    virtual const void* readHeld() { return nullptr; }
    virtual void release(const void*) {}

    const types::TypeOps& ops() const { return ops_; }

protected:
    explicit SampleStore(const types::TypeOps& ops) : ops_(ops) {}
    static constexpr std::size_t kAtOnce = 64;
    /** Assign `sample` to the free elements: to all, waiting a little for those in use, or to kAtOnce without waiting. */
    virtual void resizeElements(const void* sample, bool all) = 0;
    std::size_t extentOf(const void* sample) const { return ops_.extent ? ops_.extent(sample) : 0; }
    /** To be called when `sample`, of that extent, was written. */
    void keepSized(const void* sample, std::size_t extent) {
        if (__builtin_expect(extent > largest_.load(std::memory_order_relaxed), 0)) grow(sample, extent);
    }

    const types::TypeOps& ops_;

private:
    /** True if it is larger than all before. */
    bool noteExtent(std::size_t extent);
    void grow(const void* sample, std::size_t extent);

    std::atomic<std::size_t> largest_{0};
    std::shared_ptr<const SampleBox> prototype_;  // std::atomic_load/store only
};

}  // namespace internal
}  // namespace RTT

#endif
