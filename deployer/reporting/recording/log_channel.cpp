// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "log_channel.hpp"

#include "cdr_text.hpp"

#include <rtt/os/TimeService.hpp>

#include <algorithm>
#include <utility>

namespace OCL::recording {
namespace {

namespace mcap = oroforge::mcap;

/** As ROS counts levels. */
std::uint8_t rosLevel(RTT::LoggerLevel level) {
    constexpr std::uint8_t kDebug = 10, kInfo = 20, kWarn = 30, kError = 40, kFatal = 50;
    switch (level) {
        case RTT::Fatal:
        case RTT::Critical: return kFatal;
        case RTT::Error: return kError;
        case RTT::Warning: return kWarn;
        case RTT::Info: return kInfo;
        default: return kDebug;
    }
}

}  // namespace

LogChannel::LogChannel(bool realtime) : realtime_(realtime) { RTT::addLogObserver(*this); }

LogChannel::~LogChannel() { end(); }

void LogChannel::end() { RTT::removeLogObserver(*this); }

mcap::Schema LogChannel::schema(std::uint16_t id) {
    return {id, "rcl_interfaces/msg/Log", "ros2msg",
            "byte DEBUG=10\n"
            "byte INFO=20\n"
            "byte WARN=30\n"
            "byte ERROR=40\n"
            "byte FATAL=50\n"
            "builtin_interfaces/Time stamp\n"
            "uint8 level\n"
            "string name  # the module, component or thread\n"
            "string msg\n"
            "string file\n"
            "string function\n"
            "uint32 line\n" +
                std::string(80, '=') +
                "\n"
                "MSG: builtin_interfaces/Time\n"
                "int32 sec\n"
                "uint32 nanosec\n"};
}

mcap::Channel LogChannel::channel(std::uint16_t id, std::uint16_t schema) {
    id_ = id;
    return {id, schema, "/rosout", "cdr", {{"oroforge.kind", "log"}}};
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
    constexpr std::uint64_t kSecond = 1000000000;
    for (const Line& line : lines) {
        sequence_ += static_cast<std::uint32_t>(line.lostBefore);
        CdrText message;
        message.number(static_cast<std::uint32_t>(line.time / kSecond))
            .number(static_cast<std::uint32_t>(line.time % kSecond))
            .byte(rosLevel(line.level))
            .text(line.origin)
            .text(line.text)
            .text("")
            .text("")
            .number(0);
        if (!message.addTo(pipe, {id_, sequence_++, line.time, line.time}))
            lost_.fetch_add(1, std::memory_order_relaxed);
    }
}

}  // namespace OCL::recording
