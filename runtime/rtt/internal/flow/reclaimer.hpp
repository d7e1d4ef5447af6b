// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Deferred destruction of what the data path reads without a lock: connection lists, links between channel elements.
//
// Epoch based. A reader announces the global epoch in its own thread's record while it is inside (Guard). A thread that
// unlinks an object retires it with the current epoch; it is destroyed when no thread is inside with that or an older
// one.
//
// The reader's announcement (a store) must not be overtaken by its following loads. That costs a full barrier, so it is
// asymmetric: readers make a plain store, and the rare unlinking side runs membarrier(2), which puts a barrier into
// every running thread of the process. Without that system call a reader does a read-modify-write as it enters, and
// another one as it leaves. Either way all orders that ThreadSanitizer must see are on the atomics themselves: leaving
// releases, and the unlinking side reads the records with acquire.
#ifndef ORO_INTERNAL_RECLAIMER_HPP
#define ORO_INTERNAL_RECLAIMER_HPP

#include <rtt/internal/flow/deferred_calls.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace RTT {
namespace internal {

class RTT_API Reclaimer {
public:
    /** One per thread that was ever inside; reused after the thread has ended. */
    struct alignas(64) Record {
        std::atomic<std::uint64_t> epoch{0};  // 0: outside
        std::atomic<bool> waiting{false};     // the owner is inside and in synchronize()
        std::atomic<bool> used{false};
        // The number of threads that wait until the owner has left; one more if the kernel has no membarrier.
        std::atomic<std::uint32_t> awaited{0};
        std::atomic<std::uint32_t> rings{0};  // where they sleep
        Record* next = nullptr;               // set before the record is published
        DeferredCalls deferred;
    };

    /** While one exists, nothing that its thread can reach through atomic pointers is destroyed. Nestable; never blocks
        or allocates, except that a thread's first use takes a record from the heap when a static pool is empty. */
    class Guard {
    public:
        Guard() noexcept : record_(enter()) {}
        ~Guard() {
            if (record_) leave(*record_);
        }
        Guard(const Guard&) = delete;
        Guard& operator=(const Guard&) = delete;

    private:
        Record* const record_;  // null within another Guard
    };

    /** The calls that this thread makes as soon as it has left its outermost Guard; add to them inside one. They signal
        new samples to components. That may run user code, which must not delay any destruction. */
    static DeferredCalls& deferred() noexcept { return mine()->deferred; }

    /** For an object that the caller has unlinked. A later collect() calls `destroy(object)` when no thread can still
        use it; retire() itself never does, so it may be called with locks held. Not real-time safe. */
    static void retire(void* object, void (*destroy)(void*));

    /** Destroys the retired objects that are now unused. Call it without locks after retire(). Not real-time safe. */
    static void collect();

    /** Waits until every other thread that is inside now has left, except those in synchronize(): two threads inside
        cannot wait for each other. Blocks; not real-time safe. */
    static void synchronize();

    /** True if this thread is inside a Guard. */
    static bool inside() noexcept { return mine()->epoch.load(std::memory_order_relaxed) != 0; }

    /** See detail::thisThread(). */
    static const void* thisThread() noexcept { return mine(); }

    /** The number of retired objects that are not yet destroyed. */
    static std::size_t pending();

private:
    static Record* mine() noexcept {
        Record* record = record_;
        return __builtin_expect(record != nullptr, 1) ? record : attach();
    }
    // Only the outermost Guard announces. The announcement itself shows whether there is one: with a count of nested
    // ones each Guard of a thread would wait for the previous one.
    static Record* enter() noexcept {
        Record* const record = record_;
        if (__builtin_expect(!record, 0)) return enterSlowly();
        if (__builtin_expect(record->epoch.load(std::memory_order_relaxed) != 0, 0)) return nullptr;
        announce(*record);
        asm volatile("" ::: "memory");  // orders the compiler; membarrier orders the CPU
        return record;
    }
    static void announce(Record& record) noexcept {
        // Acquire: with the number that retire() left behind we also see that its object was unlinked. Release: a
        // thread that finds us inside again, and missed that we had left, must see what we did before.
        record.epoch.store(epoch_.load(std::memory_order_acquire), std::memory_order_release);
    }
    static void leave(Record& record) noexcept {
        // Pairs with the acquire loads of collect() and synchronize(): our use inside happens before the destruction.
        // A thread that waits for us adds itself to `awaited` first: either we find it, or it finds that we have left.
        record.epoch.store(0, std::memory_order_release);
        asm volatile("" ::: "memory");
        if (__builtin_expect(static_cast<unsigned>(!record.deferred.empty()) | record.awaited, 0)) afterwards(record);
    }
    [[gnu::cold, gnu::noinline]] static Record* enterSlowly() noexcept;
    [[gnu::cold, gnu::noinline]] static void afterwards(Record& record) noexcept;
    static Record* attach() noexcept;

    static std::atomic<std::uint64_t> epoch_;
    // Of this thread. Null before its first use, and in all threads if the kernel has no membarrier.
    static __thread Record* record_ __attribute__((tls_model("initial-exec")));
    friend struct ReclaimerState;
};

}  // namespace internal
}  // namespace RTT

#endif
