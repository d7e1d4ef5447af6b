// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TS_POOL_HPP
#define ORO_TS_POOL_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

namespace RTT {
namespace internal {

/**
 * A fixed number of objects that any number of threads take and give back. Both are real-time safe: they neither block
 * nor allocate. An object keeps its value and memory, so pools of vectors stay allocated.
 *
 * The free objects are a chain of indices. Its head carries a count of the changes. Without it, a thread stopped
 * between reading and replacing the head would not notice that the same object was taken and given back.
 */
template <class T>
class TsPool {
public:
    typedef T value_t;
    typedef std::size_t size_type;

    explicit TsPool(unsigned int size, const T& sample = T())
        : size_(size), values_(new T[size]), next_(new std::atomic<std::uint32_t>[size]) {
        data_sample(sample);
    }
    TsPool(const TsPool&) = delete;
    TsPool& operator=(const TsPool&) = delete;

    /** Null if all objects are taken. */
    T* allocate() {
        std::uint64_t first = first_.load(std::memory_order_acquire);
        for (;;) {
            const std::uint32_t index = static_cast<std::uint32_t>(first);
            if (index == kNone) return nullptr;
            // Another thread may have taken the object by now and change this; then the exchange fails.
            const std::uint32_t next = next_[index].load(std::memory_order_relaxed);
            if (first_.compare_exchange_weak(first, changed(first, next), std::memory_order_acq_rel,
                                             std::memory_order_acquire))
                return &values_[index];
        }
    }

    /** False if `value` is not an object of this pool. Give an object back only once. */
    bool deallocate(T* value) {
        const std::less<const T*> before{};
        if (!value || before(value, values_.get()) || !before(value, values_.get() + size_)) return false;
        const std::uint32_t index = static_cast<std::uint32_t>(value - values_.get());
        std::uint64_t first = first_.load(std::memory_order_acquire);
        do {
            next_[index].store(static_cast<std::uint32_t>(first), std::memory_order_relaxed);
        } while (!first_.compare_exchange_weak(first, changed(first, index), std::memory_order_acq_rel,
                                               std::memory_order_acquire));
        return true;
    }

    /** Takes all objects back and gives them this value. Only while no other thread uses the pool. */
    void data_sample(const T& sample) {
        for (std::size_t index = 0; index < size_; ++index) values_[index] = sample;
        clear();
    }
    /** Takes all objects back. Only while no other thread uses the pool. */
    void clear() {
        for (std::size_t index = 0; index < size_; ++index)
            next_[index].store(index + 1 < size_ ? static_cast<std::uint32_t>(index + 1) : kNone,
                               std::memory_order_relaxed);
        first_.store(changed(first_.load(std::memory_order_relaxed), size_ ? 0 : kNone), std::memory_order_release);
    }

    size_type capacity() const { return size_; }
    /** The number of free objects. Only while no other thread uses the pool. */
    size_type size() const {
        size_type count = 0;
        for (std::uint32_t index = static_cast<std::uint32_t>(first_.load(std::memory_order_acquire));
             index != kNone && count < size_; index = next_[index].load(std::memory_order_relaxed))
            ++count;
        return count;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    static std::uint64_t changed(std::uint64_t first, std::uint32_t index) {
        return (((first >> 32) + 1) << 32) | index;
    }

    const std::size_t size_;
    const std::unique_ptr<T[]> values_;
    const std::unique_ptr<std::atomic<std::uint32_t>[]> next_;
    std::atomic<std::uint64_t> first_{kNone};
};

}  // namespace internal
}  // namespace RTT

#endif
