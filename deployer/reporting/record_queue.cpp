// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "record_queue.hpp"

#include <utility>

namespace OCL::reporting {

RecordQueue::RecordQueue(std::size_t room) : filling_(new Part(room)), emptying_(filling_) {}

RecordQueue::~RecordQueue() {
    while (emptying_) delete std::exchange(emptying_, emptying_->next.load(std::memory_order_acquire));
}

void RecordQueue::makeRoom(std::size_t room) {
    Part* const next = new Part(room);
    // Release, pairs with pop() and empty(): a thread that sees the new ring sees all that the old one will ever have.
    filling_->next.store(next, std::memory_order_release);
    filling_ = next;
}

/** `take` takes a record from a ring; false if there is none. */
template <class Take>
bool RecordQueue::takeOldest(Take take) {
    for (;;) {
        // Must be read first: only if there is a next ring does an empty one stay empty.
        Part* const next = emptying_->next.load(std::memory_order_acquire);
        if (take(emptying_->ring)) return true;
        if (!next) return false;
        delete std::exchange(emptying_, next);
    }
}

bool RecordQueue::pop(std::vector<char>& record) {
    return takeOldest([&record](RecordRing& ring) { return ring.pop(record); });
}

bool RecordQueue::drop(char* begin, std::size_t size) {
    return takeOldest([begin, size](RecordRing& ring) { return ring.drop(begin, size); });
}

bool RecordQueue::empty() const { return !emptying_->next.load(std::memory_order_acquire) && emptying_->ring.empty(); }

}  // namespace OCL::reporting
