// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_SINK_HPP
#define RTT_DETAIL_LOG_SINK_HPP

#include <rtt/Logger.hpp>

#include <atomic>
#include <cstdio>
#include <deque>
#include <mutex>
#include <ostream>
#include <string>

namespace RTT {
namespace detail {

/** Where finished lines go: console, file and the list for getLogLine(). All functions are thread-safe. */
class LogSink {
public:
    void startup();
    void shutdown();

    /** Cheap: one relaxed load. */
    bool mayLog(LoggerLevel level) const noexcept { return level <= limit_.load(std::memory_order_relaxed); }
    void write(LoggerLevel level, const std::string& module, const std::string& text, bool flush);
    void flush();

    void setLevel(LoggerLevel level);
    LoggerLevel level() const noexcept { return level_.load(std::memory_order_relaxed); }
    void setConsole(std::ostream& stream);
    void enableConsole(bool yes);
    void enableFile(bool yes);
    void allowRealTime(bool yes);
    bool reachesConsole(LoggerLevel level) const noexcept {
        return level <= consoleLimit_.load(std::memory_order_relaxed);
    }
    bool reachesFile(LoggerLevel level) const noexcept { return level <= fileLimit_.load(std::memory_order_relaxed); }

    std::string takeLine();
    os::TimeService::ticks referenceTime() const noexcept { return reference_.load(std::memory_order_relaxed); }

private:
    void readEnvironment();
    void openFile();
    void announceStart();
    void updateLimits();
    void note(LoggerLevel level, const std::string& text);
    void writeLocked(LoggerLevel level, const std::string& module, const std::string& text, bool flush);
    void flushLocked();

    static constexpr int kNothing = -1;
    // What the settings below come down to; the most detailed level that goes to each place. Read without the mutex.
    std::atomic<int> consoleLimit_{kNothing};
    std::atomic<int> fileLimit_{kNothing};
    std::atomic<int> limit_{kNothing};  // the larger one
    std::atomic<LoggerLevel> level_{Warning};
    std::atomic<os::TimeService::ticks> reference_{0};

    std::mutex mutex_;  // for everything below, and for writing
    bool started_ = false;
    bool disabled_ = false;  // ORO_LOGLEVEL below 0
    bool consoleEnabled_ = true;
    bool fileEnabled_ = true;
    bool realTimeAllowed_ = false;
    std::ostream* console_ = nullptr;  // null: std::cerr
    std::FILE* file_ = nullptr;
    bool fileUsed_ = false;
    std::deque<std::string> recent_;
    std::string scratch_;
    std::string problem_;  // found in the environment
    bool levelGiven_ = false;
};

/** The only one; never destroyed, since static objects log when the process ends. */
LogSink& logSink();

}  // namespace detail
}  // namespace RTT
#endif
