// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_RECORD_RING_HPP
#define ORO_OCL_REPORTING_RECORD_RING_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace OCL::reporting {

/** Passes records from one thread to another in a fixed amount of memory. Neither thread ever waits for the other. */
class RecordRing {
public:
    /** Allocates at least that many bytes and touches all of them, so that there are no page faults later. */
    explicit RecordRing(std::size_t capacity);

    std::size_t capacity() const { return mask_ + 1; }
    /** False if there is no room now. Called only by the thread that fills. Real-time safe. */
    bool push(const char* record, std::size_t size);
    /** Moves the oldest record into `record`; false if there is none. Called only by the thread that empties. */
    bool pop(std::vector<char>& record);
    /** Drops the oldest record, whose first bytes it copies, at most `size`; false if there is none. Called only by the
        thread that empties. Allocates nothing. */
    bool drop(char* begin, std::size_t size);
    /** Called only by the thread that empties. */
    bool empty() const;

private:
    typedef std::uint32_t Length;

    void put(std::uint64_t at, const void* from, std::size_t size);
    void take(std::uint64_t at, void* to, std::size_t size) const;

    std::unique_ptr<char[]> bytes_;
    std::size_t mask_;
    // Bytes written and read since the beginning. The numbers only grow; the place of a byte is its number modulo the
    // capacity. Each side changes only its own number. They have cache lines of their own, as has the filling side's
    // copy of the other.
    alignas(64) std::atomic<std::uint64_t> filled_{0};
    std::uint64_t seenEmptied_ = 0;
    alignas(64) std::atomic<std::uint64_t> emptied_{0};
};

}  // namespace OCL::reporting

#endif
