// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_TIMER_HPP
#define ORO_OS_TIMER_HPP

#include <rtt/Time.hpp>
#include <rtt/os/Condition.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/os/RunnableInterface.hpp>
#include <rtt/os/TimeService.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace os {

/**
 * A set of timers, numbered from 0, that call timeout(id) when they expire. Functions are thread-safe and may be called
 * from timeout(); they take a mutex and are not meant for hard real-time paths. Times are on the monotonic clock.
 */
class RTT_API Timer : public base::RunnableInterface {
public:
    typedef int TimerId;

    /**
     * @param maxTimers number of timers
     * @param scheduler for the thread that calls timeout() and belongs to getActivity(); −1 makes no thread: run this
     *     object in an activity that is not periodic
     */
    explicit Timer(TimerId maxTimers, int scheduler = -1, int priority = 0, const std::string& name = "Timer");
    /** Ends the thread. A class that overrides timeout() must call stopThread() in its own destructor. */
    ~Timer() override;

    /** Called when timer `id` expires, in the thread of the timer. */
    virtual void timeout(TimerId id);

    /** Changes the number of timers; those that no longer exist are killed. */
    void setMaxTimers(TimerId max);
    /** Lets the timer expire after each `period` seconds. False for a bad id or a period that is not positive. */
    bool startTimer(TimerId id, Seconds period);
    /** Lets the timer expire once, after `delay` seconds. False for a bad id or a negative delay. */
    bool arm(TimerId id, Seconds delay);
    bool isArmed(TimerId id) const;
    /** Seconds until the next expiry; 0 if not armed. */
    Seconds timeRemaining(TimerId id) const;
    /** Disarms the timer and wakes its waiters. False for a bad id. */
    bool killTimer(TimerId id);
    /** Blocks until the timer expires or is killed. False if it is not armed. */
    bool waitFor(TimerId id);
    /** The same, at most until the monotonic time `deadline` (ns); false if that came first. */
    bool waitForUntil(TimerId id, nsecs deadline);

    bool initialize() override;
    void step() override;
    /** Serves the timers until breakLoop(). */
    void loop() override;
    bool breakLoop() override;
    void finalize() override;

protected:
    /** Ends the object's own thread, if there is one, and waits for that. */
    void stopThread();

private:
    class OwnActivity;
    struct Entry {
        nsecs expires = 0;        // 0: not armed
        nsecs period = 0;         // 0: one shot
        unsigned generation = 0;  // changes whenever waiters must return
    };
    bool isValid(TimerId id) const { return id >= 0 && static_cast<std::size_t>(id) < timers_.size(); }
    bool set(TimerId id, Seconds first, Seconds period);
    int serveExpired(nsecs now, TimerId& expired);
    bool leave();

    mutable Mutex mutex_;
    Condition changed_;  // for loop(): the earliest expiry may have moved
    Condition expired_;  // for waiters
    std::vector<Entry> timers_;
    unsigned changes_ = 0;  // the last generation
    bool quit_ = false;
    std::unique_ptr<OwnActivity> own_;
};

}  // namespace os
}  // namespace RTT
#endif
