// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "log_channel.hpp"

#include <reporting/mcap_file/log_message.hpp>
#include <rtt/os/TimeService.hpp>

#include <algorithm>
#include <utility>

namespace OCL::recording {
namespace {

LogLevel levelOf(RTT::LoggerLevel level) {
    switch (level) {
        case RTT::Fatal:
        case RTT::Critical: return LogLevel::Fatal;
        case RTT::Error: return LogLevel::Error;
        case RTT::Warning: return LogLevel::Warning;
        case RTT::Info: return LogLevel::Info;
        default: return LogLevel::Debug;
    }
}

}  // namespace

LogChannel::LogChannel(bool realtime) : realtime_(realtime) { RTT::addLogObserver(*this); }

LogChannel::~LogChannel() { end(); }

void LogChannel::end() { RTT::removeLogObserver(*this); }

oroforge::mcap::Channel LogChannel::channel(std::uint16_t id, std::uint16_t schema) {
    id_ = id;
    return logChannel(id, schema);
}

void LogChannel::receive(const RTT::LogEntry& entry) {
    std::int64_t time = entry.wallTime;
    if (!realtime_) time = RTT::os::TimeService::ticks2nsecs(RTT::Logger::Instance()->getReferenceTime()) + entry.time;
    const std::string_view text = entry.text.substr(0, kLongestLine);
    const std::size_t cut = entry.cut + (entry.text.size() - text.size());
    Line line{static_cast<std::uint64_t>(std::max<std::int64_t>(time, 0)), entry.level, std::string(entry.origin),
              std::string(text), 0};
    if (cut != 0) line.text += " … (" + std::to_string(cut) + " more characters)";
    const std::lock_guard<std::mutex> lock(mutex_);
    if (lines_.size() == kMostLines) {
        ++dropped_;
        lost_.fetch_add(1, std::memory_order_relaxed);
        return;
    }
    line.lostBefore = std::exchange(dropped_, 0);
    lines_.push_back(std::move(line));
}

void LogChannel::add(ChunkPipe& pipe) {
    std::deque<Line> lines;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        lines.swap(lines_);
    }
    for (const Line& line : lines) {
        sequence_ += static_cast<std::uint32_t>(line.lostBefore);
        const CdrText message = logMessage(line.time, levelOf(line.level), line.origin, line.text);
        if (!addMessage(pipe, message.bytes(), {id_, sequence_++, line.time, line.time}))
            lost_.fetch_add(1, std::memory_order_relaxed);
    }
}

}  // namespace OCL::recording
