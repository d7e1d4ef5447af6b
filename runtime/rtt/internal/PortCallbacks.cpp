// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/PortCallbacks.hpp>

#include <rtt/internal/Reclaimer.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

namespace RTT {
namespace internal {

namespace {

/** The threads that wait for a callback's return: two that wait for each other's must not go on doing so. */
class Waiting {
public:
    Waiting() {
        const std::lock_guard<std::mutex> lock(mutex());
        threads().push_back(pthread_self());
    }
    ~Waiting() {
        const std::lock_guard<std::mutex> lock(mutex());
        threads().erase(std::find(threads().begin(), threads().end(), pthread_self()));
    }
    static bool has(pthread_t thread) {
        const std::lock_guard<std::mutex> lock(mutex());
        return std::find(threads().begin(), threads().end(), thread) != threads().end();
    }

private:
    // Never destroyed: components with static storage may still remove ports while the process exits.
    static std::mutex& mutex() {
        static std::mutex* one = new std::mutex;
        return *one;
    }
    static std::vector<pthread_t>& threads() {
        static std::vector<pthread_t>* list = new std::vector<pthread_t>;
        return *list;
    }
};

}  // namespace

PortCallbacks::~PortCallbacks() { delete table_.load(); }

PortCallbacks::Entry* PortCallbacks::find(base::PortInterface* port) const {
    if (const Table* table = table_.load(std::memory_order_acquire))
        for (const EntryPtr& entry : *table)
            if (entry->port == port) return entry.get();
    return nullptr;
}

void PortCallbacks::replace(base::PortInterface* port, EntryPtr entry) {
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
        if (entry) next->push_back(std::move(entry));
        table_.store(next.release(), std::memory_order_release);
        if (old) Reclaimer::retire(const_cast<Table*>(old), [](void* table) { delete static_cast<Table*>(table); });
    }
    Reclaimer::collect();
    if (gone) waitFor(*gone);
}

void PortCallbacks::waitFor(Entry& entry) {
    // seq_cst, like call(): either it sees that the port was removed, or we see that it executes the callback.
    entry.removed.store(true, std::memory_order_seq_cst);
    const auto executes = [&entry] {
        if (entry.executing.load(std::memory_order_seq_cst) == 0) return false;
        return !pthread_equal(entry.thread.load(std::memory_order_relaxed), pthread_self());
    };
    if (!executes()) return;
    const Waiting here;
    while (executes() && !Waiting::has(entry.thread.load(std::memory_order_relaxed)))
        std::this_thread::sleep_for(std::chrono::microseconds(20));
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
    struct Executing {
        explicit Executing(Entry& e) : entry(e) {
            entry.thread.store(pthread_self(), std::memory_order_relaxed);  // seen with `executing`
            entry.executing.fetch_add(1, std::memory_order_seq_cst);
        }
        // Release: all that the callback did happens before what follows waitFor().
        ~Executing() { entry.executing.fetch_sub(1, std::memory_order_release); }
        Entry& entry;
    } const executing(*held);
    if (held->removed.load(std::memory_order_seq_cst)) return;
    held->queued.exchange(false, std::memory_order_acq_rel);
    if (running || !held->whileRunning.load(std::memory_order_relaxed)) held->callback(port);
}

}  // namespace internal
}  // namespace RTT
