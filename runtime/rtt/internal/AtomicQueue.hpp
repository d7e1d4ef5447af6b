// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ATOMIC_QUEUE_HPP
#define ORO_ATOMIC_QUEUE_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace RTT {
namespace internal {

/**
 * A bounded first-in-first-out queue of pointers, or of other small values; `T()` means "none". Any number of threads
 * may put and take. Both are real-time safe: they neither block nor allocate.
 *
 * Each cell carries a number that tells whose turn it is. In round r, after r wraps of the queue:
 *   2 r      free, for the thread that wins this position of the tail
 *   2 r + 1  filled, for the thread that wins this position of the head
 */
template <class T>
class AtomicQueue {
public:
    typedef std::size_t size_type;

    explicit AtomicQueue(unsigned int size) : size_(size ? size : 1), cells_(new Cell[size_]) {}
    AtomicQueue(const AtomicQueue&) = delete;
    AtomicQueue& operator=(const AtomicQueue&) = delete;

    /** False for `T()`, if the queue is full, or if another thread is just taking the value out of the next cell. */
    bool enqueue(const T& value) {
        if (value == T()) return false;
        std::uint64_t position = tail_.load(std::memory_order_relaxed);
        for (;;) {
            Cell& cell = cells_[position % size_];
            const std::uint64_t wanted = 2 * (position / size_), turn = cell.turn.load(std::memory_order_acquire);
            if (turn < wanted) return false;
            if (turn > wanted) {
                position = tail_.load(std::memory_order_relaxed);
            } else if (tail_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)) {
                cell.value = value;
                cell.turn.store(wanted + 1, std::memory_order_release);
                return true;
            }
        }
    }

    /** False, without a change of `result`, if the queue is empty or another thread is just putting its first value. */
    bool dequeue(T& result) {
        std::uint64_t position = head_.load(std::memory_order_relaxed);
        for (;;) {
            Cell& cell = cells_[position % size_];
            const std::uint64_t wanted = 2 * (position / size_) + 1, turn = cell.turn.load(std::memory_order_acquire);
            if (turn < wanted) return false;
            if (turn > wanted) {
                position = head_.load(std::memory_order_relaxed);
            } else if (head_.compare_exchange_weak(position, position + 1, std::memory_order_release,
                                                   std::memory_order_relaxed)) {
                result = cell.value;
                cell.turn.store(wanted + 1, std::memory_order_release);
                return true;
            }
        }
    }

    size_type capacity() const { return size_; }
    /** May be outdated at once while other threads use the queue, as may isEmpty() and isFull(). */
    size_type size() const {
        // The head first: the thread that moved it saw a tail at least as far, and so do we. It may have wrapped since.
        const std::uint64_t head = head_.load(std::memory_order_acquire), tail = tail_.load(std::memory_order_acquire);
        return tail - head < size_ ? static_cast<size_type>(tail - head) : size_;
    }
    bool isEmpty() const { return size() == 0; }
    bool isFull() const { return size() == size_; }
    void clear() {
        for (T value = T(); dequeue(value);) {
        }
    }

protected:
    /** The first value, or `T()`. Only for the thread that takes, in a queue with one such thread. */
    T firstValue() const {
        const std::uint64_t position = head_.load(std::memory_order_relaxed);
        const Cell& cell = cells_[position % size_];
        return cell.turn.load(std::memory_order_acquire) == 2 * (position / size_) + 1 ? cell.value : T();
    }

private:
    struct Cell {
        std::atomic<std::uint64_t> turn{0};
        T value = T();
    };
    const std::size_t size_;
    const std::unique_ptr<Cell[]> cells_;
    alignas(64) std::atomic<std::uint64_t> tail_{0};
    alignas(64) std::atomic<std::uint64_t> head_{0};
};

}  // namespace internal
}  // namespace RTT

#endif
