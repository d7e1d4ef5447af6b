// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_RECORD_QUEUE_HPP
#define ORO_OCL_REPORTING_RECORD_QUEUE_HPP

#include "record_ring.hpp"

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

namespace OCL::reporting {

/**
 * A RecordRing that is followed by a larger one when records become larger. The filling thread uses the new ring at
 * once. The emptying thread first empties the old ring and frees it.
 */
class RecordQueue {
public:
    /** Allocates. */
    explicit RecordQueue(std::size_t room);
    ~RecordQueue();
    RecordQueue(const RecordQueue&) = delete;
    RecordQueue& operator=(const RecordQueue&) = delete;

    // Called only by the thread that fills.
    /** False if there is no room now. Real-time safe. */
    bool push(const char* record, std::size_t size) { return filling_->ring.push(record, size); }
    /** The size of the present ring in bytes. */
    std::size_t capacity() const { return filling_->ring.capacity(); }
    /** Continues with a new ring of that size. Allocates. */
    void makeRoom(std::size_t room);

    // Called only by the thread that empties.
    /** Moves the oldest record into `record`; false if there is none. */
    bool pop(std::vector<char>& record);
    /** Drops the oldest record, whose first bytes it copies, at most `size`; false if there is none. Allocates
        nothing. */
    bool drop(char* begin, std::size_t size);
    bool empty() const;

private:
    struct Part {
        explicit Part(std::size_t room) : ring(room) {}
        RecordRing ring;
        std::atomic<Part*> next{nullptr};
    };
    template <class Take>
    bool takeOldest(Take take);

    Part* filling_;   // the last one
    Part* emptying_;  // the first one, which owns those after it
};

}  // namespace OCL::reporting

#endif
