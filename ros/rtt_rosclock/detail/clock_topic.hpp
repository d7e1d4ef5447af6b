// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCLOCK_DETAIL_CLOCK_TOPIC_HPP
#define RTT_ROSCLOCK_DETAIL_CLOCK_TOPIC_HPP

#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace rtt_rosclock {

/// A subscription to /clock, with a queue of its own for the newest message.
class ClockTopic {
public:
    /// Why there cannot be one now; empty if there can. Asks the ROS master, which takes 2 s at most.
    static std::string whyNot();

    /// `onMessage()` is called by a thread of ROS, does not block, and has poll() called soon in another thread. Registers
    /// with the ROS master: call whyNot() before.
    explicit ClockTopic(std::function<void()> onMessage);
    ~ClockTopic();
    ClockTopic(const ClockTopic&) = delete;
    ClockTopic& operator=(const ClockTopic&) = delete;
    /// `onMessage()` is not called any more. Waits for the ROS master, 2 s at most.
    void close();
    /// The time of a message that has come, in ns. False if there is none. For one thread.
    bool poll(long long& time);

private:
    struct Subscription;
    struct Closed;
    const std::shared_ptr<Subscription> subscription_;
    std::atomic<bool> isClosed_{false};
};

}  // namespace rtt_rosclock

#endif
