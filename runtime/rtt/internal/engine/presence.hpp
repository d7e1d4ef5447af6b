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
 * Which objects each thread is using, so that a thread that takes one away can wait for the others.
 *
 * A user enters the object and then looks whether it is still there; it leaves when it has finished. The thread that
 * takes the object away marks it as gone and then waits with a Waiter. Either the user finds the mark, or the waiter
 * finds the user. Only the waiter pays for the barrier between store and load (process_barrier.hpp): a user
 * executes no locked instruction, and threads that use the same object write to no common memory.
 *
 * Only the address of the object counts. A user does not touch the object once it has left.
 */
class RTT_API Presence {
public:
    typedef std::atomic<std::uint32_t> Word;
    /** Holds the address that a thread uses. */
    typedef std::atomic<std::uintptr_t> Place;

    /** Takes a record for this thread, which may allocate; otherwise its first use would do that. */
    static void prepare() noexcept {
        if (!record_) deeper();
    }
    /** This thread uses `what`, an even address, until it calls leave() with the result. Uses nest. Never blocks;
        real-time safe, except that nesting deeper than before may allocate. */
    static Place& enter(const void* what) noexcept {
        Record* record = record_;
        if (__builtin_expect(!record || record->depth == kDepth, 0)) record = deeper();
        Place& place = record->places[record->depth++];
        // Release: a waiter that finds this use, and missed the end of the previous one, must see what that one did.
        const auto word = reinterpret_cast<std::uintptr_t>(what);
        if (__builtin_expect(asymmetric_, 1)) {
            place.store(word, std::memory_order_release);
            asm volatile("" ::: "memory");  // orders the compiler; the waiter orders the CPU
        } else {
            place.exchange(word);
        }
        return place;
    }
    /** Ends the last use that this thread began. True if it was marked with keep(). */
    static bool leave(Place& place) noexcept {
        Record* const record = record_;
        // Computed, not decremented: the next use would have to wait for the old value.
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

    /** Ends all uses that this thread began after its last use of `what`. */
    static void leaveDownTo(const void* what) noexcept;
    /** Marks each unmarked use of `what` by this thread, so that leave() returns true; returns their number. */
    static unsigned keep(const void* what) noexcept;
    /** Clears `what` from the uses of this thread: another object may get its address. */
    static void forget(const void* what) noexcept;

    /** Waits until no other thread uses `what`. The constructor takes some microseconds. Lives on the stack. */
    class RTT_API Waiter {
    public:
        explicit Waiter(const void* what) noexcept;
        ~Waiter();
        Waiter(const Waiter&) = delete;
        Waiter& operator=(const Waiter&) = delete;
        /** True if another thread uses it. */
        bool others() const noexcept;
        /** Blocks until no other thread uses it; false at the monotonic time `deadline` (ns). */
        bool wait(NANO_TIME deadline) const noexcept;
        /** A futex that changes and wakes its waiters when others() may have become false. */
        const Word& word() const noexcept;

    private:
        const std::uintptr_t what_;
    };

private:
    static constexpr unsigned kDepth = 12;  // as many as fit into two cache lines
    static constexpr std::uintptr_t kKept = 1;

    /** One per thread; a thread with more than kDepth uses at once has several. */
    struct alignas(64) Record {
        Place places[kDepth] = {};  // 0: free
        // Only the owning thread touches the rest except `used`; it sets `next` before it publishes the record.
        unsigned depth = 0;
        std::atomic<bool> used{false};
        Record* outer = nullptr;
        Record* inner = nullptr;  // kept for reuse
        Record* next = nullptr;
    };
    /** Where threads wait; leave() is expensive meanwhile. Shared by objects whose addresses collide. */
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
