// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_PRESENCE_HPP
#define ORO_INTERNAL_PRESENCE_HPP

#include <rtt/os/fosi.h>
#include <rtt/rtt-config.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace RTT {
namespace internal {
namespace detail {
/** The smallest power of two that is not below `least`. */
constexpr std::size_t powerOfTwo(std::size_t least) {
    std::size_t size = 1;
    while (size < least) size *= 2;
    return size;
}
}  // namespace detail

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
        if (!record_) takeRecord();
    }
    /** This thread uses `what`, an even address, until it calls leave() with the result. Uses nest. Never blocks;
        real-time safe, except that nesting deeper than before may allocate. */
    static Place& enter(const void* what) noexcept {
        Record* const record = record_;
        if (__builtin_expect(!record || record->isFull(), 0)) return enterSlowly(what);
        Place& place = *record->free++;
        // Release: a waiter that finds this use, and missed the end of the previous one, must see what that one did.
        place.store(reinterpret_cast<std::uintptr_t>(what), std::memory_order_release);
        asm volatile("" ::: "memory");  // orders the compiler; the waiter orders the CPU
        return place;
    }
    /** Ends the last use that this thread began. True if it was marked with keep(). */
    static bool leave(Place& place) noexcept {
        recordOf(place).free = &place;  // computed, not decremented: the next use would have to wait for the old value
        const std::uintptr_t word = place.load(std::memory_order_relaxed);
        place.store(0, std::memory_order_release);
        asm volatile("" ::: "memory");
        if (__builtin_expect(attention_ != 0, 0)) left(place, word);
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
    static constexpr unsigned kDepth = 11;  // as many as fit into two cache lines
    static constexpr std::uintptr_t kKept = 1;

    struct Record;
    struct Uses {
        Place places[kDepth] = {};  // 0: free
        // Only the owning thread touches the rest except `used`; it sets `next` before it publishes the record.
        Place* free = places;
        Record* outer = nullptr;
        Record* inner = nullptr;  // kept for reuse
        Record* next = nullptr;
        std::atomic<bool> used{false};
        bool isFull() const noexcept { return free == places + kDepth; }
    };
    /** One per thread; a thread with more than kDepth uses at once has several. Aligned for recordOf(). */
    struct alignas(detail::powerOfTwo(sizeof(Uses))) Record : Uses {};
    static Record& recordOf(Place& place) noexcept {
        return *reinterpret_cast<Record*>(reinterpret_cast<std::uintptr_t>(&place) & ~(sizeof(Record) - 1));
    }
    /** Where threads wait. Shared by objects whose addresses collide. */
    struct Bell {
        Word waiters{0};
        Word rings{0};
    };
    struct State;

    static constexpr unsigned kBells = 64;
    static Bell& bellOf(std::uintptr_t what) noexcept { return bells_[(what >> 4 ^ what >> 10) % kBells]; }
    [[gnu::cold, gnu::noinline]] static Record* takeRecord() noexcept;
    [[gnu::cold, gnu::noinline]] static Place& enterSlowly(const void* what) noexcept;
    [[gnu::cold, gnu::noinline]] static void left(Place& place, std::uintptr_t word) noexcept;
    static void ring(Bell& bell) noexcept;

    static Bell bells_[kBells];
    static Word attention_;  // not 0: leave() calls left()
    // Of this thread. Null before its first use, and in all threads if the kernel has no membarrier.
    static __thread Record* record_ __attribute__((tls_model("initial-exec")));
};

}  // namespace internal
}  // namespace RTT

#endif
