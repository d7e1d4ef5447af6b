// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "log_lines.hpp"

#include <utility>

namespace OCL::live {
namespace {
constexpr std::size_t kMost = 1000;
}

LogLines::LogLines(std::function<void()> wake) : wake_(std::move(wake)) { RTT::addLogObserver(*this); }

LogLines::~LogLines() { RTT::removeLogObserver(*this); }

void LogLines::receive(const RTT::LogEntry& entry) {
    LogLine line{entry.wallTime, entry.level, std::string(entry.origin), std::string(entry.text)};
    if (entry.cut != 0) line.text += " … (" + std::to_string(entry.cut) + " more characters)";
    bool wasEmpty = false;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        wasEmpty = lines_.empty();
        if (lines_.size() == kMost) {
            lines_.pop_front();
            ++dropped_;
        }
        lines_.push_back(std::move(line));
    }
    if (wasEmpty) wake_();
}

std::vector<LogLine> LogLines::take(std::uint64_t& dropped) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<LogLine> result(std::make_move_iterator(lines_.begin()), std::make_move_iterator(lines_.end()));
    lines_.clear();
    dropped += std::exchange(dropped_, 0);
    return result;
}

}  // namespace OCL::live
