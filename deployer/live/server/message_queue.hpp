// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_MESSAGE_QUEUE_HPP
#define OROFORGE_LIVE_MESSAGE_QUEUE_HPP

#include "transport.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

namespace OCL::live {

/**
 * What waits for one client. Answers come first, all of them. Samples belong to channels: if they are more than the
 * limit, old ones are dropped, but the newest of a channel only if nothing else is left.
 */
class MessageQueue {
public:
    explicit MessageQueue(std::size_t limit) : limit_(limit) {}

    void addAnswer(Frame frame);
    void addSample(std::uint64_t channel, Frame frame);
    /** Adds the last message of a channel, an answer: it comes after the samples that wait now, even if those are
        dropped. */
    void addBehind(std::uint64_t channel, Frame frame);
    /** Samples may take so many bytes from now on. */
    void setLimit(std::size_t bytes) { limit_ = bytes; }
    /** Moves the next message out; false if there is none. */
    bool next(Frame& frame);
    /** Forgets the samples of a channel, and their count. */
    void forget(std::uint64_t channel);

    /** Samples of the channel that were dropped here. */
    std::uint64_t dropped(std::uint64_t channel) const;
    std::size_t answerBytes() const { return answerBytes_; }
    std::size_t sampleBytes() const { return sampleBytes_; }

private:
    typedef std::uint64_t Turn;
    struct Channel {
        std::map<Turn, Frame> waiting;
        std::uint64_t dropped = 0;
        std::vector<Frame> behind;  // answers
    };
    /** Makes answers of what waited for samples that have gone. */
    void release(Channel& channel);
    void makeRoom(std::size_t size, std::uint64_t channel);
    void drop(std::uint64_t channel);

    std::size_t limit_;
    std::deque<Frame> answers_;
    std::map<std::uint64_t, Channel> channels_;
    std::map<Turn, std::uint64_t> order_;  // the channel of each sample, the oldest first
    std::size_t answerBytes_ = 0, sampleBytes_ = 0;
    Turn last_ = 0;
};

}  // namespace OCL::live

#endif
