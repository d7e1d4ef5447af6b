// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How many events the connections of an appender had no room for.
#ifndef OROFORGE_LOGGING_DROPPED_EVENTS_HPP
#define OROFORGE_LOGGING_DROPPED_EVENTS_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/base/InputPortInterface.hpp>

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>

namespace OCL::logging {

/** Any thread may use it. */
class DroppedEvents {
public:
    DroppedEvents(const std::string& owner, const RTT::base::InputPortInterface& port) : owner_(owner), port_(port) {}

    /** Looks at all connections; cheap if it did so less than 0.1 s ago, unless it must. */
    void look(bool must);
    /** Writes a warning of what was dropped since the last one, at most once per second unless it is `final`. Also of
        the messages of the process that found no memory. */
    void report(bool final);

    std::size_t all();
    std::size_t of(const std::string& category);

private:
    using Clock = std::chrono::steady_clock;
    struct Connection {
        RTT::base::ChannelElementBase::shared_ptr channel;  // so that its address stays its own
        std::string category;
        std::size_t capacity = 0, dropped = 0;
    };
    struct Counts {
        std::size_t capacity = 0, dropped = 0, reported = 0;
    };
    void lookLocked();

    const std::string owner_;
    const RTT::base::InputPortInterface& port_;
    std::mutex mutex_;
    std::map<const void*, Connection> connections_;
    std::map<std::string, Counts> categories_;
    Clock::time_point looked_{}, reported_{};
};

/** A warning of messages that found no memory in this process since the last one, whichever appender that reported. */
void reportLackOfMemory(const std::string& owner);

}  // namespace OCL::logging

#endif
