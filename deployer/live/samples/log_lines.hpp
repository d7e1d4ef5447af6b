// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_LOG_LINES_HPP
#define OROFORGE_LIVE_LOG_LINES_HPP

#include <rtt/LogReceiver.hpp>

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace OCL::live {

/** A line of the log. */
struct LogLine {
    std::int64_t time = 0;  ///< ns since 1970
    RTT::LoggerLevel level = RTT::Info;
    std::string origin, text;
};

/** Follows the log, beside its other receivers, as long as it exists. */
class LogLines final : private RTT::LogReceiver {
public:
    /** `wake` is called by the thread of the log if there are lines after there were none. */
    explicit LogLines(std::function<void()> wake);
    ~LogLines() override;
    LogLines(const LogLines&) = delete;
    LogLines& operator=(const LogLines&) = delete;

    /** The lines since the last call, at most the newest 1000; `dropped` grows by those that are not among them. Any
        thread. */
    std::vector<LogLine> take(std::uint64_t& dropped);

private:
    void receive(const RTT::LogEntry& entry) override;

    const std::function<void()> wake_;
    std::mutex mutex_;
    std::deque<LogLine> lines_;
    std::uint64_t dropped_ = 0;
};

}  // namespace OCL::live

#endif
