// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_SINK_HPP
#define RTT_DETAIL_LOG_SINK_HPP

#include <rtt/Logger.hpp>
#include <rtt/detail/log_clock.hpp>
#include <rtt/detail/log_colors.hpp>
#include <rtt/detail/log_drain.hpp>
#include <rtt/detail/log_file.hpp>
#include <rtt/detail/log_format.hpp>
#include <rtt/detail/log_queue.hpp>
#include <rtt/detail/log_relay.hpp>

#include <atomic>
#include <deque>
#include <mutex>
#include <ostream>
#include <string>
#include <string_view>

namespace RTT {
namespace detail {

/**
 * Where finished lines go: console, file, LogReceiver and the list for getLogLine(). All functions are thread-safe.
 *
 *   write() ─┬─ thread is not real-time ─► mutex ─► queue is emptied ─► console, file, LogRelay
 *            └─ real-time ─► queue ─► LogDrain wakes up ─► drain() ─► mutex ─► console, file, LogRelay
 *
 * docs/design/logging.md says why.
 */
class LogSink : private LogRelay::Owner {
public:
    LogSink() : relay_(*this), observers_(*this) {}
    void startup();
    void shutdown();

    /** Real-time safe in a real-time thread. `cut` is the number of characters that were cut off. */
    void write(LoggerLevel level, std::string_view module, std::string_view text, bool flush, std::size_t cut = 0);
    /** The same for a line that is the text alone; flushes. */
    void writeBare(LoggerLevel level, std::string_view text);
    /** Puts a line into the queue and wakes the LogDrain. Real-time safe. */
    void enqueue(LoggerLevel level, std::string_view module, std::string_view text, std::size_t cut = 0) noexcept;
    /** Does nothing in a real-time thread: queued lines are flushed when they are written. */
    void flush();
    /** Writes the lines in the queue. */
    void drain();
    /** Starts the LogDrain, which runs from __os_init(), or the first real-time os::Thread, to shutdown(). */
    void startDrain();
    /** At the end of the process: writes the queue; from now on each thread writes itself, and to std::cerr as
        console. */
    void finish();
    void beforeFork();
    void afterFork(bool inChild);
    /** Writes queue and file buffer from a signal handler, unless another thread holds the mutex for too long. */
    void drainDying() noexcept;

    void setLevel(LoggerLevel level);
    LoggerLevel level() const noexcept { return level_.load(std::memory_order_relaxed); }
    void setConsole(std::ostream& stream);
    void enableConsole(bool yes);
    void enableFile(bool yes);
    void allowRealTime(bool yes);
    void setTime(LogTime time);
    LogTime time() const noexcept { return time_.load(std::memory_order_relaxed); }
    /** See Logger. Waits for the previous one. */
    LogReceiver* setReceiver(LogReceiver* receiver, LogReceiverUse use);
    LogReceiver* setObserver(LogReceiver* observer);
    /** Waits until the observer has got what was logged before, a second at most. */
    void deliverToObserver();
    bool reachesConsole(LoggerLevel level) const noexcept {
        return level != Never && level <= consoleLimit_.load(std::memory_order_relaxed);
    }
    bool reachesFile(LoggerLevel level) const noexcept {
        return level != Never && level <= fileLimit_.load(std::memory_order_relaxed);
    }

    std::string takeLine();
    os::TimeService::ticks referenceTime() const noexcept { return reference_.load(std::memory_order_relaxed); }
    void setReferenceTime(os::TimeService::ticks ticks) noexcept { reference_.store(ticks, std::memory_order_relaxed); }

private:
    void apply(const LogSettings& settings);
    void announceStart(const LogNotes& notes);
    void updateLimits();
    void notTaken(const LogParts& line) override;
    void warn(const std::string& text) override;
    void note(LoggerLevel level, const std::string& text);
    LogReceiver* takeFrom(LogRelay& relay, LogReceiver* next, LogReceiverUse use);
    LogParts stamped(LogParts parts) const noexcept;
    // These two set the time of the line.
    void enqueue(const LogParts& parts) noexcept;
    void writeNow(LogParts parts, bool flush);
    void writeLocked(const LogParts& parts);
    void writeToFile(const LogRelay::Lines& lines);
    void compose(const LogParts& parts);
    void drainLocked();
    void flushLocked();
    /** Somebody reads the wall time of lines. */
    bool showsWallTime() const noexcept {
        return time() == LogTime::Wall || relay_.isRunning() || observers_.isRunning();
    }
    nsecs now() const noexcept { return os::TimeService::Instance()->getTicks(referenceTime()); }

    static constexpr int kNothing = -1;
    // The result of the settings below: the most detailed level for each destination. Read without the mutex.
    std::atomic<int> consoleLimit_{kNothing};
    std::atomic<int> fileLimit_{kNothing};
    std::atomic<LoggerLevel> level_{Warning};
    std::atomic<LogTime> time_{LogTime::Relative};
    std::atomic<os::TimeService::ticks> reference_{0};
    std::atomic<bool> finished_{false};
    LogQueue queue_;
    LogDrain drainer_;
    LogRelay relay_;
    LogRelay observers_;

    std::mutex mutex_;  // for everything below, and for writing
    bool started_ = false;
    bool disabled_ = false;  // ORO_LOGLEVEL below 0
    bool consoleEnabled_ = true;
    bool fileEnabled_ = true;
    bool realTimeAllowed_ = false;
    bool timeGiven_ = false;           // by setTime()
    std::ostream* console_ = nullptr;  // null: std::cerr
    LogFile file_;
    LogColors colors_;
    UtcOffset utcOffset_;
    bool receiving_ = false;
    bool observing_ = false;
    bool insteadOfFile_ = false;  // the receiver
    std::deque<std::string> recent_;
    std::string scratch_, painted_;
};

/** The only sink. Never destroyed, because static objects log when the process ends. */
LogSink& logSink();

/** The most detailed level of any destination. Not a member: a message that is not visible reads nothing else. */
extern std::atomic<int> logLimit;
inline bool logMayReach(LoggerLevel level) noexcept { return level <= logLimit.load(std::memory_order_relaxed); }

}  // namespace detail
}  // namespace RTT
#endif
