// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_LOG_CHANNEL_HPP
#define OROFORGE_RECORDING_LOG_CHANNEL_HPP

#include "chunk_pipe.hpp"

#include <reporting/mcap/records.hpp>
#include <rtt/LogReceiver.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

namespace OCL::recording {

/** A channel with the lines of the log while it exists, as messages that viewers show as a log. Used by one thread at a
    time, but for lost(). */
class LogChannel final : private RTT::LogReceiver {
public:
    /** @param realtime the times of messages are those of the day; otherwise, those of the TimeService. */
    explicit LogChannel(bool realtime);
    ~LogChannel() override;
    LogChannel(const LogChannel&) = delete;
    LogChannel& operator=(const LogChannel&) = delete;

    oroforge::mcap::Channel channel(std::uint16_t id, std::uint16_t schema);

    /** Adds the lines that have come. Allocates if there are any. */
    void add(ChunkPipe& pipe);
    /** No more lines come. Waits for those that were logged before, a second at most. */
    void end();
    /** Lines for which there was no room. */
    std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

private:
    struct Line {
        std::uint64_t time;
        RTT::LoggerLevel level;
        std::string origin, text;
        std::uint64_t lostBefore;
    };
    static constexpr std::size_t kMostLines = 1000;
    static constexpr std::size_t kLongestLine = std::size_t(1) << 16;

    void receive(const RTT::LogEntry& entry) override;

    const bool realtime_;
    std::uint16_t id_ = 0;
    std::uint32_t sequence_ = 0;
    std::mutex mutex_;
    std::deque<Line> lines_;
    std::uint64_t dropped_ = 0;  // behind the last line
    std::atomic<std::uint64_t> lost_{0};
};

}  // namespace OCL::recording

#endif
