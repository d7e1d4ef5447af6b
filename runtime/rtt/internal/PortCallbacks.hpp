// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_PORT_CALLBACKS_HPP
#define ORO_INTERNAL_PORT_CALLBACKS_HPP

#include <rtt/rtt-config.h>

#include <boost/function.hpp>

#include <pthread.h>

#include <atomic>
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
        may be destroyed then; except within that callback, and if it is itself waiting here. Not real-time safe. */
    void set(base::PortInterface* port, const Callback& callback);
    void remove(base::PortInterface* port);

    /** Marks the port as waiting for its callback; `running`: the component was running when it asked for that. True if the
        caller is to queue it, false if it is queued already or unknown. Any thread; real-time safe. */
    bool announce(base::PortInterface* port, bool running);
    /** Withdraws an announcement that could not be queued. */
    void withdraw(base::PortInterface* port);
    /** Calls the callback of a port that was queued. What was announced while the component was running is dropped when it
        no longer is: it may be on its way to destruction. In the component's thread. */
    void call(base::PortInterface* port, bool running);

private:
    struct Entry {
        base::PortInterface* port;
        Callback callback;
        std::atomic<bool> queued{false};
        std::atomic<bool> whileRunning{false};
        std::atomic<bool> removed{false};
        std::atomic<int> executing{0};               // more than one if the callback comes back to itself
        std::atomic<pthread_t> thread{pthread_t()};  // that executes it
    };
    typedef std::shared_ptr<Entry> EntryPtr;
    typedef std::vector<EntryPtr> Table;

    Entry* find(base::PortInterface* port) const;
    void replace(base::PortInterface* port, EntryPtr entry);
    static void waitFor(Entry& entry);

    std::mutex mutex_;
    std::atomic<const Table*> table_{nullptr};  // read under an internal::Reclaimer::Guard
};

}  // namespace internal
}  // namespace RTT

#endif
