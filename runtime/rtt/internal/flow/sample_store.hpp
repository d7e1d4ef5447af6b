// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The storage between a writer and a reader: one interface, implemented once for all types by TypeOps.
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
#include <cstdint>
#include <memory>

namespace RTT {
namespace types {
struct TypeOps;
}
namespace internal {
class SampleBox;

/** The kind of storage wanted: the part of a ConnPolicy that matters here. */
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

/** Storage of samples. Any number of threads may use a LockFree or a Locked one in any role; only one thread at a time
    may use an Unsync one. write(), read() and clear() allocate nothing themselves and are as real-time safe as the
    assignment of a sample, except that a Locked store takes a mutex. A sample that is larger than all before
    (types::SampleExtent) is also assigned to up to 64 free elements, so that later samples fit into them. */
class RTT_API SampleStore {
public:
    /** The preallocated samples are copies of `first`, which may be null. Null if the type has no default constructor
        and no first sample is given. */
    static std::unique_ptr<SampleStore> make(const types::TypeOps& ops, const StoreSpec& spec, const void* first);
    virtual ~SampleStore();
    SampleStore(const SampleStore&) = delete;
    SampleStore& operator=(const SampleStore&) = delete;

    /** Fails if a buffer is full, or if more threads use a lock-free storage at once than it was made for. */
    virtual WriteStatus write(const void* sample) = 0;
    virtual FlowStatus read(void* sample, bool copyOld) = 0;
    virtual void clear() = 0;

    /** Assigns `sample` to all free preallocated elements, so that later assignments need not allocate. With `reset` it
        drops all stored samples; without, it does nothing after a sizing sample at least as large. Other threads may
        use the storage meanwhile. Not real-time safe. */
    void setSample(const void* sample, bool reset);
    /** Copies the last sizing sample; false if there was none. Not real-time safe. */
    bool getSample(void* sample) const;

    virtual std::size_t capacity() const { return 1; }
    /** The number of unread samples; an estimate while other threads use the storage. */
    virtual std::size_t size() const = 0;
    /** The number of samples refused or dropped because the buffer was full. */
    virtual std::size_t dropped() const { return 0; }

    /** Of a LockFree data store: a number of the sample that read() gives, another one after each write. 0 if there is
        no sample. */
    virtual std::uint64_t newest() const { return 0; }

    /** The time of each write is kept from now on, which then reads the clock: some 20 ns more. A LockFree buffer does
        that, others give false. Not real-time safe. */
    virtual bool keepTimes() { return false; }
    /** Reads a new sample only. `time` is when it was written, in ns since 1970; 0 if that is not known. */
    virtual FlowStatus readTimed(void* sample, std::int64_t& time) {
        time = 0;
        return read(sample, false);
    }

    /** The oldest sample, unchanged until release(); null if none. At most one per thread. For StoreSpec::held. */
    virtual const void* readHeld() { return nullptr; }
    virtual void release(const void*) {}

    const types::TypeOps& ops() const { return ops_; }

protected:
    explicit SampleStore(const types::TypeOps& ops) : ops_(ops) {}
    static constexpr std::size_t kAtOnce = 64;
    /** Assigns `sample` to free elements: to all, waiting a little for those in use, or to kAtOnce without waiting. */
    virtual void resizeElements(const void* sample, bool all) = 0;
    std::size_t extentOf(const void* sample) const { return ops_.extent ? ops_.extent(sample) : 0; }
    /** Call it after writing `sample`, which has that extent. */
    void keepSized(const void* sample, std::size_t extent) {
        if (__builtin_expect(extent > largest_.load(std::memory_order_relaxed), 0)) grow(sample, extent);
    }

    const types::TypeOps& ops_;

private:
    /** True if `extent` is larger than all before. */
    bool noteExtent(std::size_t extent);
    void grow(const void* sample, std::size_t extent);

    std::atomic<std::size_t> largest_{0};
    std::shared_ptr<const SampleBox> prototype_;  // std::atomic_load/store only
};

}  // namespace internal
}  // namespace RTT

#endif
