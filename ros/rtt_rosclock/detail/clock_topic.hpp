// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCLOCK_DETAIL_CLOCK_TOPIC_HPP
#define RTT_ROSCLOCK_DETAIL_CLOCK_TOPIC_HPP

#include <functional>
#include <memory>
#include <string>

namespace rtt_rosclock {

/// A subscription to /clock, with a queue of its own for the newest message.
class ClockTopic {
public:
    /// Why there cannot be one now; empty if there can. Asks the ROS master.
    static std::string whyNot();

    /// `onMessage()` is called by a thread of ROS, and calls poll() soon in another thread.
    explicit ClockTopic(std::function<void()> onMessage);
    ~ClockTopic();
    /// The time of a message that has come, in ns. False if there is none. For one thread.
    bool poll(long long& time);

private:
    struct Subscription;
    std::unique_ptr<Subscription> subscription_;
};

}  // namespace rtt_rosclock

#endif
