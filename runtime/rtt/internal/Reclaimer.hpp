// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Deferred destruction for what the data path reads without a lock: connection lists and links between channel elements.
//
// Epoch based. A reader announces the global epoch in its own thread's record while it is inside (Guard). Whoever
// unlinks an object retires it with the epoch of that moment; it is destroyed when no thread is inside with that epoch
// or an older one.
//
// The reader's announcement (a store) must not be overtaken by its following loads. That costs a full barrier, so it is
// asymmetric: readers make a plain store, and the rare unlinking side runs membarrier(2), which puts a barrier into every
// running thread of the process. Without that system call readers do a read-modify-write of the epoch instead.
// Either way all orders that ThreadSanitizer must see are on the atomics themselves: leaving is a release store, and
// the unlinking side reads the records with acquire.
#ifndef ORO_INTERNAL_RECLAIMER_HPP
#define ORO_INTERNAL_RECLAIMER_HPP

#include <rtt/internal/DeferredCalls.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace RTT {
namespace internal {

class RTT_API Reclaimer {
public:
    /** One per thread that ever was inside; reused after the thread ended. */
    struct alignas(64) Record {
        std::atomic<std::uint64_t> epoch{0};  // 0: outside
        std::atomic<bool> waiting{false};     // the owner is inside and in synchronize()
        std::atomic<bool> used{false};
        Record* next = nullptr;  // set before the record is published
        DeferredCalls deferred;
    };

    /** While one exists, nothing that its thread can reach through atomic pointers is destroyed. Nestable, never blocks,
        never allocates (a thread's very first use takes a record from a static pool, and from the heap when that is empty). */
    class Guard {
    public:
        Guard() noexcept : record_(enter()) {}
        ~Guard() {
            if (record_) leave(*record_);
        }
        Guard(const Guard&) = delete;
        Guard& operator=(const Guard&) = delete;

    private:
        Record* const record_;  // null within another one
    };

    /** What this thread calls as soon as it has left its outermost Guard; to be added to inside one. Used for telling
        components of new samples: that may run their code, which must not hold up the destruction of anything. */
    static DeferredCalls& deferred() noexcept { return mine()->deferred; }

    /** Has `object` destroyed by `destroy(object)` when no thread can still use it: in a later collect(), never in this
        call, so it may be made with locks held. The caller has unlinked it already. Not real-time safe. */
    static void retire(void* object, void (*destroy)(void*));

    /** Destroys what is pending and unused by now. To be called, without locks, after whatever retires. Not real-time safe. */
    static void collect();

    /** Waits until every other thread that is inside now has left. A thread that is itself inside is not waited for
        while it too is in here, so two such threads cannot wait for each other. Blocks; not real-time safe. */
    static void synchronize();

    /** This thread is inside a Guard. */
    static bool inside() noexcept { return mine()->epoch.load(std::memory_order_relaxed) != 0; }

    /** See detail::thisThread(). */
    static const void* thisThread() noexcept { return mine(); }

    /** Number of retired objects not yet destroyed. */
    static std::size_t pending();

private:
    static Record* mine() noexcept {
        Record* record = record_;
        return __builtin_expect(record != nullptr, 1) ? record : attach();
    }
    // Only the outermost Guard announces. Whether there is one is read from the announcement: a count of nested ones would make
    // each Guard of a thread wait for the previous one.
    static Record* enter() noexcept {
        Record& record = *mine();
        if (__builtin_expect(record.epoch.load(std::memory_order_relaxed) != 0, 0)) return nullptr;
        // Acquire: with the number that retire() left behind we also see that its object was unlinked. Release: who finds that
        // we are inside again, and not that we have left before, must see what we did then.
        record.epoch.store(epoch_.load(std::memory_order_acquire), std::memory_order_release);
        if (__builtin_expect(asymmetric_, 1))
            asm volatile("" ::: "memory");  // keeps the compiler's order; membarrier sees to the CPU's
        else
            // Either this comes after the unlinking side's own addition and sees what it unlinked, or before, and then
            // that one sees our announcement.
            epoch_.fetch_add(0, std::memory_order_acq_rel);
        return &record;
    }
    static void leave(Record& record) noexcept {
        // Pairs with the acquire loads of collect() and synchronize(): what we did inside happens before the destruction.
        record.epoch.store(0, std::memory_order_release);
        if (__builtin_expect(!record.deferred.empty(), 0)) record.deferred.run();
    }
    static Record* attach() noexcept;

    static std::atomic<std::uint64_t> epoch_;
    static bool asymmetric_;
    static __thread Record* record_ __attribute__((tls_model("initial-exec")));
    friend struct ReclaimerState;
};

}  // namespace internal
}  // namespace RTT

#endif
