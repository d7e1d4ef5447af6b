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
 * A RecordRing that is followed by a larger one when records have become larger: the filling thread goes on to the new one at
 * once, the emptying thread when it has emptied the old one, which it then frees.
 */
class RecordQueue {
public:
    /** Allocates. */
    explicit RecordQueue(std::size_t room);
    ~RecordQueue();
    RecordQueue(const RecordQueue&) = delete;
    RecordQueue& operator=(const RecordQueue&) = delete;

    // For the one thread that fills.
    /** False if there is no room for it now. Real-time safe. */
    bool push(const char* record, std::size_t size) { return filling_->ring.push(record, size); }
    /** Bytes that the present ring takes. */
    std::size_t capacity() const { return filling_->ring.capacity(); }
    /** Goes on with a new ring of that size. Allocates. */
    void makeRoom(std::size_t room);

    // For the one thread that empties.
    /** Moves the oldest one into `record`; false if there is none. */
    bool pop(std::vector<char>& record);
    bool empty() const;

private:
    struct Part {
        explicit Part(std::size_t room) : ring(room) {}
        RecordRing ring;
        std::atomic<Part*> next{nullptr};
    };
    Part* filling_;   // the last one
    Part* emptying_;  // the first one, which owns those behind it
};

}  // namespace OCL::reporting

#endif
