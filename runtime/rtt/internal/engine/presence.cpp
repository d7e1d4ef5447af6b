// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/presence.hpp>

#include <rtt/internal/engine/detail/process_barrier.hpp>
#include <rtt/internal/engine/detail/thread_records.hpp>
#include <rtt/os/futex.hpp>

#include <pthread.h>

#include <new>

namespace RTT::internal {

namespace {
/** The content of a place that is in use, after forget(). */
constexpr std::uintptr_t kForgotten = 2;

/** Asked while the library is being loaded: with several threads the kernel needs some 10 ms for it. */
[[maybe_unused]] const bool askedEarly = detail::offersProcessBarrier();
}  // namespace

Presence::Bell Presence::bells_[kBells];
Presence::Word Presence::attention_{0};
__thread Presence::Record* Presence::record_ = nullptr;

struct RTT_HIDE Presence::State {
    State() {
        pthread_key_create(&key, &State::threadEnds);
        // Safe only here: no thread has entered anything before its first takeRecord(), which comes through here.
        asymmetric = detail::offersProcessBarrier();
        if (!asymmetric) attention_.fetch_add(1);
    }

    /** Never destroyed: threads may still run while the process exits. */
    static State& instance() {
        alignas(State) static unsigned char place[sizeof(State)];
        static State* const state = new (place) State;
        return *state;
    }

    static void threadEnds(void* first) {
        // Another key's destructor may still enter an object: it then takes a new record, and this is called again.
        select(nullptr);
        for (auto* record = static_cast<Record*>(first); record;) {
            Record* const inner = record->inner;
            record->outer = record->inner = nullptr;
            Records::giveBack(record);
            record = inner;
        }
    }

    /** The next use of this thread gets a place of `record`. */
    static void select(Record* record) noexcept {
        current = record;
        record_ = asymmetric ? record : nullptr;
    }

    template <class Visit>
    static void forOwn(const void* what, Visit visit) {
        const auto word = reinterpret_cast<std::uintptr_t>(what);
        for (Record* record = current; record; record = record->outer)
            for (Place& place : record->places)
                if (place.load(std::memory_order_relaxed) == word) visit(place);
    }

    typedef detail::ThreadRecords<Record, 64> Records;
    Records records;
    pthread_key_t key;
    /** False if the kernel has no membarrier(2): then each use is a read-modify-write. */
    static bool asymmetric;
    static __thread Record* current;
};

bool Presence::State::asymmetric = false;
__thread Presence::Record* Presence::State::current = nullptr;

// The first record of a thread, or another one if all places of the last are taken.
Presence::Record* Presence::takeRecord() noexcept {
    State& state = State::instance();
    Record* const outer = State::current;
    if (outer && !outer->isFull()) return outer;
    Record* record = outer ? outer->inner : nullptr;
    if (!record) {
        record = state.records.take();
        record->outer = outer;
        if (outer)
            outer->inner = record;
        else
            pthread_setspecific(state.key, record);
    }
    if (outer) attention_.fetch_add(1);  // until left() goes back to `outer`
    State::select(record);
    return record;
}

Presence::Place& Presence::enterSlowly(const void* what) noexcept {
    Place& place = *takeRecord()->free++;
    const auto word = reinterpret_cast<std::uintptr_t>(what);
    if (State::asymmetric)
        place.store(word, std::memory_order_release);
    else
        place.exchange(word);
    return place;
}

void Presence::left(Place& place, std::uintptr_t word) noexcept {
    if (!State::asymmetric) place.exchange(0);
    Bell& bell = bellOf(word & ~kKept);
    if (bell.waiters != 0) ring(bell);
    const Record& record = recordOf(place);
    if (&place != record.places || !record.outer) return;
    State::select(record.outer);
    attention_.fetch_sub(1);
}

void Presence::leaveDownTo(const void* what) noexcept {
    for (;;) {
        Place& last = State::current->free[-1];
        if ((last.load(std::memory_order_relaxed) & ~kKept) == reinterpret_cast<std::uintptr_t>(what)) return;
        leave(last);
    }
}

unsigned Presence::keep(const void* what) noexcept {
    unsigned number = 0;
    State::forOwn(what, [&](Place& place) {
        place.store(reinterpret_cast<std::uintptr_t>(what) | kKept, std::memory_order_release);
        ++number;
    });
    return number;
}

void Presence::forget(const void* what) noexcept {
    State::forOwn(what, [](Place& place) { place.store(kForgotten, std::memory_order_release); });
    ring(bellOf(reinterpret_cast<std::uintptr_t>(what)));
}

void Presence::ring(Bell& bell) noexcept {
    bell.rings.fetch_add(1, std::memory_order_release);
    os::detail::futexWakeAll(bell.rings);
}

// A user that leaves frees its place and then reads the number of waiters. Either it finds this waiter, or this waiter
// finds the free place.
Presence::Waiter::Waiter(const void* what) noexcept : what_(reinterpret_cast<std::uintptr_t>(what)) {
    State::instance();
    bellOf(what_).waiters.fetch_add(1);
    attention_.fetch_add(1);
    if (State::asymmetric) detail::processBarrier();
}

Presence::Waiter::~Waiter() {
    attention_.fetch_sub(1);
    bellOf(what_).waiters.fetch_sub(1);
}

bool Presence::Waiter::others() const noexcept {
    const auto isOwn = [](const Record* record) {
        const Record* own = State::current;
        while (own && own != record) own = own->outer;
        return own != nullptr;
    };
    for (Record* record = State::instance().records.first(); record; record = record->next) {
        if (isOwn(record)) continue;
        // Uses nest: no use after a thread's first free place began before this waiter's barrier.
        for (const Place& place : record->places) {
            const std::uintptr_t word = place.load();
            if ((word & ~kKept) == what_) return true;
            if (word == 0) break;
        }
    }
    return false;
}

bool Presence::Waiter::wait(NANO_TIME deadline) const noexcept {
    for (;;) {
        const std::uint32_t seen = word();
        if (!others()) return true;
        if (deadline != os::detail::kForever && rtos_get_time_ns() >= deadline) return false;
        os::detail::futexWait(word(), seen, deadline);
    }
}

const Presence::Word& Presence::Waiter::word() const noexcept { return bellOf(what_).rings; }

}  // namespace RTT::internal
