// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_PRESENCE_HPP
#define ORO_INTERNAL_PRESENCE_HPP

#include <rtt/os/fosi.h>
#include <rtt/rtt-config.h>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {

/**
 * What each thread is using at this moment, so that a thread which takes an object away can wait for the others.
 *
 * A user enters the object and then looks whether it is still there; it leaves when it has finished. The thread that takes the
 * object away marks it as gone and then waits with a Waiter. Either the user finds the mark, or the waiter finds the
 * user. The barrier that this needs between a store and a load is paid by the waiter alone (detail/process_barrier.hpp): a
 * user executes no locked instruction, and threads that use the same object write to no common memory.
 *
 * Only the address of the object counts. What is waited for is not touched by the user any more once it has left.
 */
class RTT_API Presence {
public:
    typedef std::atomic<std::uint32_t> Word;
    /** Where a thread says what it uses. */
    typedef std::atomic<std::uintptr_t> Place;

    /** Has a record for this thread, which its first use would take otherwise; that may take memory. */
    static void prepare() noexcept {
        if (!record_) deeper();
    }
    /** This thread uses `what`, which has an even address, until it calls leave() with the result. Uses nest. Never blocks;
        real-time safe, but one that nests deeper than before may take memory. */
    static Place& enter(const void* what) noexcept {
        Record* record = record_;
        if (__builtin_expect(!record || record->depth == kDepth, 0)) record = deeper();
        Place& place = record->places[record->depth++];
        // Release: a waiter that finds this use, and not that the previous one has ended, must see what was done in that.
        const auto word = reinterpret_cast<std::uintptr_t>(what);
        if (__builtin_expect(asymmetric_, 1)) {
            place.store(word, std::memory_order_release);
            asm volatile("" ::: "memory");  // keeps the compiler's order; the waiter sees to the CPU's
        } else {
            place.exchange(word);
        }
        return place;
    }
    /** Ends the use that this thread began last. True if it was marked with keep(). */
    static bool leave(Place& place) noexcept {
        Record* const record = record_;
        // Not one less than it was: the next use would have to wait until that is known.
        record->depth = static_cast<unsigned>(&place - record->places);
        const std::uintptr_t word = place.load(std::memory_order_relaxed);
        if (__builtin_expect(asymmetric_, 1)) {
            place.store(0, std::memory_order_release);
            asm volatile("" ::: "memory");
        } else {
            place.exchange(0);
        }
        Bell& bell = bellOf(word & ~kKept);
        if (__builtin_expect(bell.waiters != 0, 0)) ring(bell);
        if (__builtin_expect(&place == record->places && record->outer, 0)) record_ = record->outer;
        return (word & kKept) != 0;
    }

    /** Ends all that this thread has entered after the last `what`. */
    static void leaveDownTo(const void* what) noexcept;
    /** Makes leave() true for each use of `what` by this thread that is not marked yet; returns their number. */
    static unsigned keep(const void* what) noexcept;
    /** What this thread uses is no more `what`: something else may get its address. */
    static void forget(const void* what) noexcept;

    /** A thread that waits until no other thread uses `what`. Takes some microseconds; lives on the stack. */
    class RTT_API Waiter {
    public:
        explicit Waiter(const void* what) noexcept;
        ~Waiter();
        Waiter(const Waiter&) = delete;
        Waiter& operator=(const Waiter&) = delete;
        /** Another thread uses it. */
        bool others() const noexcept;
        /** Blocks until no other thread uses it; false if that is not so at the monotonic time `deadline` (ns). */
        bool wait(NANO_TIME deadline) const noexcept;
        /** A futex that is changed and woken up after others() may have become false. */
        const Word& word() const noexcept;

    private:
        const std::uintptr_t what_;
    };

private:
    static constexpr unsigned kDepth = 12;  // as many as fit into two cache lines
    static constexpr std::uintptr_t kKept = 1;

    /** One per thread; a thread that uses more at once has several. */
    struct alignas(64) Record {
        Place places[kDepth] = {};  // 0: free
        // The rest but `used` is touched by the owning thread only, `next` before the record is published.
        unsigned depth = 0;
        std::atomic<bool> used{false};
        Record* outer = nullptr;
        Record* inner = nullptr;  // kept for the next time
        Record* next = nullptr;
    };
    /** Where threads wait, which makes leave() expensive meanwhile; shared by objects whose addresses collide. */
    struct Bell {
        Word waiters{0};
        Word rings{0};
    };
    struct State;

    static constexpr unsigned kBells = 64;
    static Bell& bellOf(std::uintptr_t what) noexcept { return bells_[(what >> 4 ^ what >> 10) % kBells]; }
    [[gnu::cold, gnu::noinline]] static Record* deeper() noexcept;
    [[gnu::cold, gnu::noinline]] static void ring(Bell& bell) noexcept;

    static Bell bells_[kBells];
    static bool asymmetric_;
    static __thread Record* record_ __attribute__((tls_model("initial-exec")));
};

}  // namespace internal
}  // namespace RTT

#endif
