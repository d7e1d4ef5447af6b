// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Most stores have one reader. It takes samples without an atomic read-modify-write until a second thread reads.
#ifndef ORO_INTERNAL_DETAIL_SOLE_READER_HPP
#define ORO_INTERNAL_DETAIL_SOLE_READER_HPP

#include <rtt/internal/engine/detail/process_barrier.hpp>
#include <rtt/internal/engine/detail/this_thread.hpp>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {
namespace detail {

/**
 * Which thread, if any, is the only one that takes samples out of a store.
 *
 *   undecided    a thread counts itself in `inside_` while it reads; one that reads often enough in a row becomes the
 *                sole reader, unless another one is inside at that moment
 *   sole         the sole reader says in `reading_` that it reads and then looks whether it is still the sole one
 *   ending       another thread reads
 *   shared       for good
 *
 * A thread that ends "sole" marks that first and then looks at `reading_`. It alone pays for the barrier that both need
 * between store and load (process_barrier.hpp). The store is shared only after the barrier: others may come first.
 */
class SoleReader {
public:
    /** One read of this thread. Real-time safe; the read that makes the store shared makes a system call. */
    class Reading {
    public:
        explicit Reading(SoleReader& reader) noexcept : reader_(reader), alone_(reader.enterAlone()) {
            if (__builtin_expect(!alone_, 0)) reader.enter(*this);
        }
        ~Reading() {
            if (__builtin_expect(alone_, 1))
                reader_.reading_.store(false, std::memory_order_release);
            else if (counted_)
                reader_.leave();
        }
        Reading(const Reading&) = delete;
        Reading& operator=(const Reading&) = delete;
        /** True if no other thread takes samples meanwhile. */
        bool alone() const noexcept { return alone_; }
        /** True if the previous sole reader is taking a sample: this thread must not take one. */
        bool late() const noexcept { return late_; }

    private:
        friend class SoleReader;
        SoleReader& reader_;
        const bool alone_;
        bool counted_ = false, late_ = false;
    };

private:
    static constexpr unsigned kInARow = 8, kUndecided = 64;

    static const void* ending() noexcept { return &kMarks[0]; }
    static const void* shared() noexcept { return &kMarks[1]; }

    bool enterAlone() noexcept {
        const void* const me = thisThread();
        if (__builtin_expect(thread_.load(std::memory_order_relaxed) != me, 0)) return false;
        reading_.store(true, std::memory_order_relaxed);
        asm volatile("" ::: "memory");  // orders the compiler; a thread that ends "sole" orders the CPU
        if (__builtin_expect(thread_.load(std::memory_order_relaxed) == me, 1)) return true;
        reading_.store(false, std::memory_order_release);
        return false;
    }
    [[gnu::noinline]] void enter(Reading& reading) noexcept {
        reading.counted_ = count();
        reading.late_ = reading_.load(std::memory_order_acquire);
    }
    /** True if the caller has to leave(). */
    bool count() noexcept {
        const void* thread = thread_.load(std::memory_order_acquire);
        if (thread == shared()) return false;
        if (!thread) {
            inside_.fetch_add(1);
            thread = thread_.load();
            if (!thread) return true;
            inside_.fetch_sub(1);
        }
        if (thread != ending()) thread_.compare_exchange_strong(thread, ending());
        processBarrier();
        thread_.store(shared());
        return false;
    }
    [[gnu::noinline]] void leave() noexcept {
        const void* const me = thisThread();
        const bool again = last_.exchange(me, std::memory_order_relaxed) == me;
        const unsigned inARow = again ? inARow_.load(std::memory_order_relaxed) + 1 : 1;
        inARow_.store(inARow, std::memory_order_relaxed);
        const void* none = nullptr;
        if (reads_.fetch_add(1, std::memory_order_relaxed) == kUndecided)
            thread_.compare_exchange_strong(none, shared());
        else if (inARow == kInARow && offersBarrier() && thread_.compare_exchange_strong(none, me) &&
                 inside_.load() != 1)
            thread_.store(shared());
        inside_.fetch_sub(1);
    }
    static bool offersBarrier() noexcept {
        static const bool offered = offersProcessBarrier();
        return offered;
    }

    static constexpr char kMarks[2] = {};
    std::atomic<const void*> thread_{nullptr};
    std::atomic<bool> reading_{false};
    // Used while undecided:
    std::atomic<const void*> last_{nullptr};
    std::atomic<std::uint32_t> inside_{0}, inARow_{0}, reads_{0};
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
