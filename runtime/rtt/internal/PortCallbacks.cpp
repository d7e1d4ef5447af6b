// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/PortCallbacks.hpp>

#include <rtt/internal/Reclaimer.hpp>

namespace RTT {
namespace internal {

PortCallbacks::~PortCallbacks() { delete table_.load(); }

PortCallbacks::Entry* PortCallbacks::find(base::PortInterface* port) const {
    if (const Table* table = table_.load(std::memory_order_acquire))
        for (const EntryPtr& entry : *table)
            if (entry->port == port) return entry.get();
    return nullptr;
}

void PortCallbacks::replace(base::PortInterface* port, EntryPtr entry) {
    {
        std::lock_guard<std::mutex> lock(mutex_);
        const Table* old = table_.load(std::memory_order_relaxed);
        auto next = std::make_unique<Table>();
        if (old)
            for (const EntryPtr& other : *old)
                if (other->port != port) next->push_back(other);
        if (entry) next->push_back(std::move(entry));
        table_.store(next.release(), std::memory_order_release);
        if (old) Reclaimer::retire(const_cast<Table*>(old), [](void* table) { delete static_cast<Table*>(table); });
    }
    Reclaimer::collect();
}

void PortCallbacks::set(base::PortInterface* port, const Callback& callback) {
    auto entry = std::make_shared<Entry>();
    entry->port = port;
    entry->callback = callback;
    replace(port, entry);
}

void PortCallbacks::remove(base::PortInterface* port) { replace(port, nullptr); }

bool PortCallbacks::announce(base::PortInterface* port, bool running) {
    Reclaimer::Guard guard;
    Entry* entry = find(port);
    if (!entry) return false;
    entry->whileRunning.store(running, std::memory_order_relaxed);  // seen with `queued`
    // Acquire-release with call(): if the port is still queued, its callback has yet to begin and will see our sample.
    return !entry->queued.exchange(true, std::memory_order_acq_rel);
}

void PortCallbacks::withdraw(base::PortInterface* port) {
    Reclaimer::Guard guard;
    if (Entry* entry = find(port)) entry->queued.store(false, std::memory_order_release);
}

void PortCallbacks::call(base::PortInterface* port, bool running) {
    EntryPtr held;  // the callback may remove its own port
    {
        Reclaimer::Guard guard;
        if (const Table* table = table_.load(std::memory_order_acquire))
            for (const EntryPtr& entry : *table)
                if (entry->port == port) held = entry;
    }
    if (!held) return;
    held->queued.exchange(false, std::memory_order_acq_rel);
    if (running || !held->whileRunning.load(std::memory_order_relaxed)) held->callback(port);
}

}  // namespace internal
}  // namespace RTT
