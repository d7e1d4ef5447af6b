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
 * What a component does when its event ports have data. Ports are added and removed by the component while other
 * threads announce data; announcing never locks: it reads a table that is replaced as a whole.
 */
class RTT_API PortCallbacks {
public:
    typedef boost::function<void(base::PortInterface*)> Callback;

    PortCallbacks() = default;
    ~PortCallbacks();
    PortCallbacks(const PortCallbacks&) = delete;
    PortCallbacks& operator=(const PortCallbacks&) = delete;

    /** Both wait until a callback of the port that is executing has returned, so that the port and what the callback uses
        may be destroyed then; except within that callback, and if it is itself waiting here (detail::Waiting). With
        `executesMessages` those of the components that this thread is executing are executed meanwhile. Not real-time
        safe. */
    void set(base::PortInterface* port, const Callback& callback);
    void remove(base::PortInterface* port, bool executesMessages = false);

    /** Marks the port as waiting for its callback; `running`: the component was running when it asked for that. Zero if
        somebody has queued it already, or if it is unknown; otherwise the caller is to queue it, to wake the
        component, and then to tell queued(). Any thread; real-time safe. */
    std::uint64_t announce(base::PortInterface* port, bool running);
    /** From here on nobody else needs to queue the port before its callback begins. Any thread; real-time safe. */
    void queued(base::PortInterface* port, std::uint64_t announcement);
    enum class Announced { Not, WhileRunning, WhileStopped };
    /** While it lives, set() and remove() of this port wait, like for its callback. In the component's thread; real-time
        safe. */
    class RTT_API Execution;
    /** Calls the callback of a port that waits for it; nothing happens if it does not (several had queued it). What was
        announced while the component was running is dropped when it no longer is: it may be on its way to
        destruction. In the component's thread. */
    void call(base::PortInterface* port, bool running);
    /** The next port that waits for its callback; null if there is none. The ports have numbers: `last` is that of the
        previous one, 0 at first. */
    base::PortInterface* nextAnnounced(std::uint64_t& last) const;

private:
    struct Entry {
        base::PortInterface* port;
        std::uint64_t number = 0;  // in order of creation, from 1; the table is sorted by it
        Callback callback;
        // Odd: the port waits for its callback. Never the same odd number twice, nor that of another port.
        std::atomic<std::uint64_t> round{0};
        std::atomic<std::uint64_t> queuedRound{0};  // the port was queued in this one
        std::atomic<bool> whileRunning{false};
        std::atomic<bool> removed{false};
        std::atomic<int> executing{0};               // more than one if the callback comes back to itself
        std::atomic<pthread_t> thread{pthread_t()};  // that executes it
    };
    typedef std::shared_ptr<Entry> EntryPtr;
    typedef std::vector<EntryPtr> Table;

    EntryPtr hold(base::PortInterface* port) const;
    Entry* find(base::PortInterface* port) const;
    void replace(base::PortInterface* port, EntryPtr entry, bool executesMessages);
    static void waitFor(Entry& entry, bool executesMessages);

    std::mutex mutex_;
    std::uint64_t entries_ = 0;                 // made so far
    std::atomic<const Table*> table_{nullptr};  // read under an internal::Reclaimer::Guard
};

class RTT_API PortCallbacks::Execution {
public:
    Execution(const PortCallbacks& callbacks, base::PortInterface* port);
    ~Execution();
    Execution(const Execution&) = delete;
    Execution& operator=(const Execution&) = delete;

    /** What the component was when the port was announced last; `Not` if the port has been removed. */
    Announced announced() const;

private:
    friend class PortCallbacks;
    const EntryPtr entry_;  // a callback may remove its own port
};

}  // namespace internal
}  // namespace RTT

#endif
