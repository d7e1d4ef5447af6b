// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_THREAD_STATE_HPP
#define RTT_OS_DETAIL_THREAD_STATE_HPP

#include <rtt/os/Thread.hpp>
#include <rtt/os/detail/wake_word.hpp>

#include <mutex>

namespace RTT {
namespace os {

/**
 * The state of a Thread. Two small state machines work together:
 *
 *  life      Idle → Starting → Active → Stopping → Idle. A thread that makes a transition by compare-exchange owns the
 *            next one, so concurrent start() and stop() need no lock and cannot wait for each other.
 *  session   what the thread must do and does: kDue (start() asked for a session) and kRunning. 0 means that
 *            the thread executes nothing and will not until the next start(); stop() waits for that.
 *
 * All use the default (sequentially consistent) order, because they change when something starts or stops, not in a
 * cycle. The cycle reads `running` in that order too: see Thread::mayRun(), which pairs it with inUserCode.
 */
struct Thread::State {
    enum Life : int { kIdle, kStarting, kActive, kStopping };
    enum : std::uint32_t { kDue = 1u, kRunning = 2u };

    detail::WakeWord wakeWord;
    std::atomic<int> life{kIdle};
    std::atomic<std::uint32_t> session{0};
    std::atomic<bool> running{false};  // the session may go on
    std::atomic<bool> exit{false};     // the thread must end
    std::atomic<int> inUserCode{0};
    std::uint32_t earlyReasons = 0;  // touched by the thread only
    int overruns = 0;                // touched by the thread only

    std::atomic<nsecs> period{0};
    std::atomic<nsecs> stopTimeout{0};
    std::atomic<int> maxOverrun{-1};
    std::atomic<int> waitPolicy{ORO_WAIT_ABS};

    std::mutex scheduling;  // orders changes of the next two
    std::atomic<int> scheduler{ORO_SCHED_OTHER};
    std::atomic<int> priority{0};

    std::string name;
    RTOS_TASK task{};
    std::atomic<bool> joinable{false};  // false again once terminate() was called

    bool change(Life from, Life to) {
        int expected = from;
        return life.compare_exchange_strong(expected, to);
    }
    bool isPast(Life from) const { return life.load() >= from; }
};

}  // namespace os
}  // namespace RTT
#endif
