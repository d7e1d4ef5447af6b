// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/port_callbacks.hpp>

#include <rtt/internal/flow/detail/waiting.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

namespace RTT::internal {

using detail::Waiting;

PortCallbacks::~PortCallbacks() { delete table_.load(); }

PortCallbacks::Entry* PortCallbacks::find(base::PortInterface* port) const {
    if (const Table* table = table_.load(std::memory_order_acquire))
        for (const EntryPtr& entry : *table)
            if (entry->port == port) return entry.get();
    return nullptr;
}

void PortCallbacks::replace(base::PortInterface* port, EntryPtr entry, bool executesMessages) {
    EntryPtr gone;
    {
        std::lock_guard<std::mutex> lock(mutex_);
        const Table* old = table_.load(std::memory_order_relaxed);
        auto next = std::make_unique<Table>();
        if (old)
            for (const EntryPtr& other : *old) {
                if (other->port == port)
                    gone = other;
                else
                    next->push_back(other);
            }
        if (entry) {
            entry->number = ++entries_;
            entry->round.store(entry->number << 32, std::memory_order_relaxed);
            next->push_back(std::move(entry));
        }
        table_.store(next.release(), std::memory_order_release);
        if (old) Reclaimer::retire(const_cast<Table*>(old), [](void* table) { delete static_cast<Table*>(table); });
    }
    Reclaimer::collect();
    if (gone) waitFor(*gone, executesMessages);
}

void PortCallbacks::waitFor(Entry& entry, bool executesMessages) {
    // seq_cst, like Execution: either it sees that the port was removed, or we see that it executes the callback.
    entry.removed.store(true, std::memory_order_seq_cst);
    const auto executes = [&entry] {
        if (entry.executing.load(std::memory_order_seq_cst) == 0) return false;
        return !pthread_equal(entry.thread.load(std::memory_order_relaxed), pthread_self());
    };
    if (!executes()) return;
    const Waiting here;
    for (;;) {
        const std::uint32_t seen = Waiting::now();
        if (!executes() || Waiting::has(entry.thread.load(std::memory_order_relaxed))) return;
        here.sleep(seen, executesMessages);
    }
}

void PortCallbacks::set(base::PortInterface* port, const Callback& callback) {
    auto entry = std::make_shared<Entry>();
    entry->port = port;
    entry->callback = callback;
    replace(port, entry, false);
}

void PortCallbacks::remove(base::PortInterface* port, bool executesMessages) {
    replace(port, nullptr, executesMessages);
}

// A round is odd from the first announcement to the beginning of the callback. A thread that finds it odd relies on
// another one only if that one has queued the port in this round: a thread that was preempted before it could do so may
// have a lower priority.
std::uint64_t PortCallbacks::announce(base::PortInterface* port, bool running) {
    Reclaimer::Guard guard;
    Entry* entry = find(port);
    if (!entry) return 0;
    entry->whileRunning.store(running, std::memory_order_relaxed);  // ordered by `round`
    // Acquire-release with call(): if the round has not ended, the callback has yet to begin and will see our sample.
    const std::uint64_t round = entry->round.fetch_or(1, std::memory_order_acq_rel) | 1;
    return entry->queuedRound.load(std::memory_order_acquire) == round ? 0 : round;
}

void PortCallbacks::queued(base::PortInterface* port, std::uint64_t announcement) {
    Reclaimer::Guard guard;
    // If the round has ended meanwhile this has no effect; at worst it hides that the port is queued in the next one.
    if (Entry* entry = find(port)) entry->queuedRound.store(announcement, std::memory_order_release);
}

PortCallbacks::EntryPtr PortCallbacks::hold(base::PortInterface* port) const {
    Reclaimer::Guard guard;
    if (const Table* table = table_.load(std::memory_order_acquire))
        for (const EntryPtr& entry : *table)
            if (entry->port == port) return entry;
    return nullptr;
}

PortCallbacks::Execution::Execution(const PortCallbacks& callbacks, base::PortInterface* port)
    : entry_(callbacks.hold(port)) {
    if (!entry_) return;
    entry_->thread.store(pthread_self(), std::memory_order_relaxed);  // ordered by `executing`
    entry_->executing.fetch_add(1, std::memory_order_seq_cst);
}

// Everything the callback did happens before what follows waitFor(). seq_cst: either waitFor() finds that we have left,
// or mayBeOver() finds its thread.
PortCallbacks::Execution::~Execution() {
    if (!entry_) return;
    entry_->executing.fetch_sub(1, std::memory_order_seq_cst);
    Waiting::mayBeOver();
}

PortCallbacks::Announced PortCallbacks::Execution::announced() const {
    if (!entry_ || entry_->removed.load(std::memory_order_seq_cst)) return Announced::Not;
    return entry_->whileRunning.load(std::memory_order_relaxed) ? Announced::WhileRunning : Announced::WhileStopped;
}

void PortCallbacks::call(base::PortInterface* port, bool running) {
    const Execution execution(*this, port);
    if (execution.announced() == Announced::Not) return;
    Entry& entry = *execution.entry_;
    if ((entry.round.load(std::memory_order_acquire) & 1) == 0) return;
    entry.round.fetch_add(1, std::memory_order_acq_rel);
    if (running || !entry.whileRunning.load(std::memory_order_relaxed)) entry.callback(port);
}

base::PortInterface* PortCallbacks::nextAnnounced(std::uint64_t& last) const {
    Reclaimer::Guard guard;
    if (const Table* table = table_.load(std::memory_order_acquire))
        for (const EntryPtr& entry : *table)
            if (entry->number > last && entry->round.load(std::memory_order_acquire) & 1) {
                last = entry->number;
                return entry->port;
            }
    return nullptr;
}

}  // namespace RTT::internal
