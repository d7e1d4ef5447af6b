// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DUE_PORTS_HPP
#define ORO_INTERNAL_DUE_PORTS_HPP

#include <atomic>
#include <cstddef>
#include <vector>

namespace RTT {
namespace base {
class PortInterface;
}
namespace internal {

/** The ports whose callbacks are due and have to wait, because their component waits, or because the queue was full.
    Real-time safe. Only for the engine's thread, except any() and miss(). */
class DuePorts {
public:
    DuePorts() { ports_.reserve(16); }  // its final capacity

    bool any() const { return deferred_ || missed_; }
    /** A port that becomes due now has to wait behind others. */
    bool waiting() const { return !ports_.empty(); }
    void defer(base::PortInterface* port) {
        if (ports_.size() == ports_.capacity()) return miss();
        ports_.push_back(port);
        deferred_ = true;
    }
    /** A port found no room: all ports of the component have to be looked at. Any thread. */
    void miss() {
        // An exchange, so that the thread that clears the flag sees what all threads that set it did before.
        missed_.exchange(true);
    }

    /** Calls `call(port)` for each, in order. That returns false if this object is gone. */
    template <class Call>
    void callDeferred(Call&& call) {
        if (!deferred_) return;
        // By index: a callback that waits may add to the list.
        for (std::size_t i = 0; i != ports_.size(); ++i)
            if (!call(ports_[i])) return;
        ports_.clear();
        deferred_ = false;
    }
    /** True if there was a miss() since the last time. A thread that missed has announced its port before, and triggers
        afterwards. */
    bool takeMissed() { return missed_ && missed_.exchange(false); }

private:
    std::vector<base::PortInterface*> ports_;
    std::atomic<bool> deferred_{false};  // ports_ is not empty
    std::atomic<bool> missed_{false};
};

}  // namespace internal
}  // namespace RTT

#endif
