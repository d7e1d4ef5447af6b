// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/reclaimer.hpp>

#include <rtt/internal/engine/detail/process_barrier.hpp>
#include <rtt/internal/engine/detail/thread_records.hpp>
#include <rtt/os/futex.hpp>

#include <pthread.h>

#include <mutex>
#include <vector>

namespace RTT::internal {

std::atomic<std::uint64_t> Reclaimer::epoch_{1};
__thread Reclaimer::Record* Reclaimer::record_ = nullptr;

struct RTT_HIDE ReclaimerState {
    typedef Reclaimer::Record Record;
    struct Retired {
        void* object;
        void (*destroy)(void*);
        std::uint64_t epoch;
    };

    ReclaimerState() {
        pthread_key_create(&key_, &ReclaimerState::threadEnds);
        // Safe only here: no thread can be inside before the first attach(), which comes through instance().
        asymmetric = detail::offersProcessBarrier();
    }

    /** Never destroyed: threads may still run, and ports be destroyed, while the process exits. */
    static ReclaimerState& instance() {
        alignas(ReclaimerState) static unsigned char place[sizeof(ReclaimerState)];
        static ReclaimerState* state = new (place) ReclaimerState;
        return *state;
    }

    Record* attach() {
        if (own) return own;
        // A thread that retires an object after this sees the record; one that did before has unlinked it before we
        // look.
        own = records_.take();
        pthread_setspecific(key_, own);
        if (asymmetric)
            Reclaimer::record_ = own;
        else
            own->awaited.fetch_add(1);
        return own;
    }

    /** Makes what other threads did before visible here, and what we did before visible to what they do from now on. */
    static void barrier() {
        if (!asymmetric) return;  // additions to epoch_ and `awaited` do it, see enterSlowly() and afterwards()
        detail::processBarrier();
    }

    /** True if it destroyed an object, which may have retired others. */
    bool collectOnce() {
        std::vector<Retired> unused;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (retired_.empty()) return false;
            barrier();
            const std::uint64_t oldest = oldestInside();
            std::size_t kept = 0;
            for (const Retired& one : retired_) {
                if (one.epoch < oldest)
                    unused.push_back(one);
                else
                    retired_[kept++] = one;
            }
            retired_.resize(kept);
        }
        for (const Retired& one : unused) one.destroy(one.object);  // without the lock: they may retire others
        return !unused.empty();
    }

    /** The smallest announced epoch; the maximum if no thread is inside. */
    std::uint64_t oldestInside() const {
        std::uint64_t oldest = ~std::uint64_t(0);
        for (Record* r = records_.first(); r; r = r->next) {
            const std::uint64_t epoch = r->epoch.load(std::memory_order_seq_cst);
            if (epoch != 0 && epoch < oldest) oldest = epoch;
        }
        return oldest;
    }

    /** True if its thread is inside with this or an older epoch, and not in synchronize(). */
    static bool uses(const Record& record, std::uint64_t epoch) {
        const std::uint64_t inside = record.epoch.load(std::memory_order_seq_cst);
        return inside != 0 && inside <= epoch && !record.waiting.load(std::memory_order_seq_cst);
    }

    static void waitFor(Record& record, std::uint64_t epoch) {
        record.awaited.fetch_add(1);
        barrier();
        for (;;) {
            const std::uint32_t seen = record.rings.load(std::memory_order_acquire);
            if (!uses(record, epoch)) break;
            os::detail::futexWait(record.rings, seen, os::detail::kForever);
        }
        record.awaited.fetch_sub(1);
    }

    static void wakeThoseWaitingFor(Record& record) {
        if (record.awaited == (asymmetric ? 0u : 1u)) return;
        record.rings.fetch_add(1, std::memory_order_release);
        os::detail::futexWakeAll(record.rings);
    }

    static void threadEnds(void* record) {
        // Another key's destructor may still use a port: it then attaches anew, and this is called again.
        Reclaimer::record_ = own = nullptr;
        if (!asymmetric) static_cast<Record*>(record)->awaited.fetch_sub(1);
        Records::giveBack(static_cast<Record*>(record));
    }

    static constexpr std::size_t kPool = 64;
    typedef detail::ThreadRecords<Record, kPool> Records;
    pthread_key_t key_;
    Records records_;
    std::mutex mutex_;
    std::vector<Retired> retired_;
    /** False if the kernel has no membarrier(2). */
    static bool asymmetric;
    static __thread Record* own;
};

bool ReclaimerState::asymmetric = false;
__thread Reclaimer::Record* ReclaimerState::own = nullptr;

Reclaimer::Record* Reclaimer::attach() noexcept { return ReclaimerState::instance().attach(); }

Reclaimer::Record* Reclaimer::enterSlowly() noexcept {
    Record& record = *attach();
    if (record.epoch.load(std::memory_order_relaxed) != 0) return nullptr;
    announce(record);
    // Without membarrier: either this comes after the unlinking side's own addition and sees what it unlinked, or it
    // comes before, and then that side sees our announcement.
    if (!ReclaimerState::asymmetric) epoch_.fetch_add(0, std::memory_order_acq_rel);
    return &record;
}

void Reclaimer::afterwards(Record& record) noexcept {
    if (!ReclaimerState::asymmetric) record.epoch.exchange(0);
    ReclaimerState::wakeThoseWaitingFor(record);
    record.deferred.run();
}

void Reclaimer::retire(void* object, void (*destroy)(void*)) {
    ReclaimerState& state = ReclaimerState::instance();
    const std::lock_guard<std::mutex> lock(state.mutex_);
    // A thread that announces a larger epoch has loaded it after this change, so after the caller unlinked the object.
    const std::uint64_t epoch = epoch_.fetch_add(1, std::memory_order_seq_cst);
    state.retired_.push_back({object, destroy, epoch});
}

void Reclaimer::collect() {
    while (ReclaimerState::instance().collectOnce()) {
    }
}

void Reclaimer::synchronize() {
    ReclaimerState& state = ReclaimerState::instance();
    Record* const self = mine();
    if (inside()) {
        self->waiting.store(true, std::memory_order_seq_cst);
        ReclaimerState::wakeThoseWaitingFor(*self);
    }
    const std::uint64_t epoch = epoch_.fetch_add(1, std::memory_order_seq_cst);
    ReclaimerState::barrier();
    for (Record* r = state.records_.first(); r; r = r->next)
        if (r != self && ReclaimerState::uses(*r, epoch)) ReclaimerState::waitFor(*r, epoch);
    self->waiting.store(false, std::memory_order_release);
    collect();
}

std::size_t Reclaimer::pending() {
    ReclaimerState& state = ReclaimerState::instance();
    const std::lock_guard<std::mutex> lock(state.mutex_);
    return state.retired_.size();
}

}  // namespace RTT::internal
