// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_PORT_CALLBACKS_HPP
#define ORO_INTERNAL_PORT_CALLBACKS_HPP

#include <rtt/rtt-config.h>

#include <boost/function.hpp>

#include <pthread.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace RTT {
namespace base {
class PortInterface;
}
namespace internal {

/**
 * The callbacks of a component's event ports. The component adds and removes ports while other threads announce data.
 * Announcing never locks: it reads a table that is replaced as a whole.
 */
class RTT_API PortCallbacks {
public:
    typedef boost::function<void(base::PortInterface*)> Callback;

    PortCallbacks() = default;
    ~PortCallbacks();
    PortCallbacks(const PortCallbacks&) = delete;
    PortCallbacks& operator=(const PortCallbacks&) = delete;

    /** Both wait until an executing callback of the port has returned, so that the port and whatever the callback uses
        may be destroyed then. They do not wait within that callback, or if its thread is waiting here too
        (detail::Waiting). With `executesMessages` the components that this thread is executing execute their messages
        meanwhile. Not real-time safe. */
    void set(base::PortInterface* port, const Callback& callback);
    void remove(base::PortInterface* port, bool executesMessages = false);

    /** Marks the port as waiting for its callback; `running` says whether the component was running at that time. Zero
        if the port is queued already, or unknown; otherwise the caller must queue it, wake the component, and then call
        queued(). Any thread; real-time safe. */
    std::uint64_t announce(base::PortInterface* port, bool running);
    /** From here on no other thread needs to queue the port before its callback begins. Any thread; real-time safe. */
    void queued(base::PortInterface* port, std::uint64_t announcement);
    enum class Announced { Not, WhileRunning, WhileStopped };
    /** While it exists, set() and remove() of this port wait, as for its callback. In the component's thread; real-time
        safe. */
    class RTT_API Execution;
    /** Calls the callback of a port that waits for it; does nothing for another port, which several threads had queued.
        Drops an announcement made while the component was running if it no longer is: it may be about to be destroyed.
        In the component's thread. */
    void call(base::PortInterface* port, bool running);
    /** The next port that waits for its callback; null if there is none. `last` is the number of the previous one, 0 at
        first. */
    base::PortInterface* nextAnnounced(std::uint64_t& last) const;

private:
    struct Entry {
        base::PortInterface* port;
        std::uint64_t number = 0;  // from 1, in order of creation; the table is sorted by it
        Callback callback;
        // Odd: the port waits for its callback. No odd number is used twice, or for another port.
        std::atomic<std::uint64_t> round{0};
        std::atomic<std::uint64_t> queuedRound{0};  // in which the port was queued
        std::atomic<bool> whileRunning{false};
        std::atomic<bool> removed{false};
        std::atomic<int> executing{0};               // above one if the callback is nested
        std::atomic<pthread_t> thread{pthread_t()};  // executes the callback
    };
    typedef std::shared_ptr<Entry> EntryPtr;
    typedef std::vector<EntryPtr> Table;

    EntryPtr hold(base::PortInterface* port) const;
    Entry* find(base::PortInterface* port) const;
    void replace(base::PortInterface* port, EntryPtr entry, bool executesMessages);
    static void waitFor(Entry& entry, bool executesMessages);

    std::mutex mutex_;
    std::uint64_t entries_ = 0;                 // the number of entries made
    std::atomic<const Table*> table_{nullptr};  // read within a Reclaimer::Guard
};

class RTT_API PortCallbacks::Execution {
public:
    Execution(const PortCallbacks& callbacks, base::PortInterface* port);
    ~Execution();
    Execution(const Execution&) = delete;
    Execution& operator=(const Execution&) = delete;

    /** The state of the component at the last announcement of the port; `Not` if the port has been removed. */
    Announced announced() const;

private:
    friend class PortCallbacks;
    const EntryPtr entry_;  // a callback may remove its own port
};

}  // namespace internal
}  // namespace RTT

#endif
