// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_EXTRAS_DETAIL_POLL_SET_HPP
#define RTT_EXTRAS_DETAIL_POLL_SET_HPP

#include <rtt/Time.hpp>
#include <rtt/os/Mutex.hpp>

#include <poll.h>
#include <vector>

namespace RTT {
namespace extras {
namespace detail {

/** The result of PollSet::wait(). */
struct PollResult {
    bool woken = false;    // wakeFd is readable
    bool changed = false;  // the set was changed meanwhile: wait again
    bool ready = false;    // some descriptors are ready
    int closed = -1;       // this descriptor was not open and has been removed
    int error = 0;         // errno of a wait that failed; the next wait() begins with a pause
};

/** File descriptors for which one thread waits; any thread may change the set meanwhile. */
class PollSet {
public:
    PollSet();

    /** Adds a descriptor; false if it is in the set already. */
    bool add(int fd);
    bool remove(int fd);
    void clear();
    bool contains(int fd) const;
    /** True if it was ready in the last wait() and has not been removed since. */
    bool isReady(int fd) const;
    void forgetReady();

    /** Waits, at most until the monotonic time `deadline`, for the set and for `wakeFd`. Called only by the waiting
        thread. */
    PollResult wait(int wakeFd, nsecs deadline);

private:
    struct Watched {
        int fd;
        bool ready;
    };
    std::vector<Watched>::const_iterator find(int fd) const;
    void copyWatched();
    bool pollUntil(std::size_t count, nsecs deadline);
    void noteResults(PollResult& result);

    mutable os::Mutex mutex_;
    std::vector<Watched> watched_;
    unsigned version_ = 0;  // changes with the members of watched_

    // Used only by the waiting thread. polled_[0] is wakeFd; the others are watched_, in its order, as of
    // polledVersion_.
    std::vector<pollfd> polled_;
    unsigned polledVersion_ = 0;
    bool failed_ = false;
};

}  // namespace detail
}  // namespace extras
}  // namespace RTT
#endif
