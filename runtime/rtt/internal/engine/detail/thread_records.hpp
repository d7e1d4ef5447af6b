// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_THREAD_RECORDS_HPP
#define ORO_INTERNAL_DETAIL_THREAD_RECORDS_HPP

#include <atomic>
#include <cstddef>

namespace RTT {
namespace internal {
namespace detail {

/**
 * Records in which threads announce what they are doing to other threads. A thread takes one and leaves it to another
 * thread when it ends, so there are only as many as threads that existed at the same time. A `Record` has the members
 * `std::atomic<bool> used{false}` and `Record* next = nullptr`. The first `kPool` of them need no heap.
 */
template <class Record, std::size_t kPool>
class ThreadRecords {
public:
    /** Never blocks. */
    Record* take() {
        Record* const record = reuse();
        return record ? record : add();
    }
    static void giveBack(Record* record) { record->used.store(false, std::memory_order_release); }
    /** The first of a list linked by `next`, with all records taken before, in the sequentially consistent order. */
    Record* first() const { return records_.load(); }

private:
    struct Block {
        Record records[kPool];
        std::atomic<Block*> next{nullptr};
    };

    Record* reuse() {
        for (Record* r = records_.load(std::memory_order_acquire); r; r = r->next) {
            bool used = false;
            if (!r->used.load(std::memory_order_relaxed) &&
                r->used.compare_exchange_strong(used, true, std::memory_order_acquire))
                return r;
        }
        return nullptr;
    }
    Record* add() {
        const std::size_t i = pooled_.fetch_add(1, std::memory_order_relaxed);
        Record* const record = i < kPool ? &pool_[i] : further(i - kPool);
        record->used.store(true, std::memory_order_relaxed);
        record->next = records_.load(std::memory_order_relaxed);
        while (!records_.compare_exchange_weak(record->next, record)) {
        }
        return record;
    }

    /** In blocks: a thread that walks a thousand scattered records would wait for memory most of the time. */
    Record* further(std::size_t i) {
        for (std::atomic<Block*>* link = &blocks_;; i -= kPool) {
            Block* block = link->load(std::memory_order_acquire);
            if (!block) {
                auto* const made = new Block;
                if (link->compare_exchange_strong(block, made))
                    block = made;
                else
                    delete made;
            }
            if (i < kPool) return &block->records[i];
            link = &block->next;
        }
    }

    std::atomic<Record*> records_{nullptr};
    std::atomic<std::size_t> pooled_{0};
    Record pool_[kPool];
    std::atomic<Block*> blocks_{nullptr};
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
