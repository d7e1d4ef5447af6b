// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_sink.hpp>

#include <rtt/detail/log_format.hpp>
#include <rtt/os/own_file.hpp>
#include <rtt/os/real_time_thread.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <pthread.h>
#include <unistd.h>

namespace RTT::detail {

namespace {
constexpr std::size_t kRecentLines = 1000;
}

LogSink& logSink() {
    static LogSink& sink = *[] {
        auto* const made = new LogSink;
        // If another thread held the mutexes during a fork(), those of the child would never be unlocked.
        pthread_atfork([] { logSink().beforeFork(); }, [] { logSink().afterFork(false); },
                       [] { logSink().afterFork(true); });
        return made;
    }();
    return sink;
}

std::atomic<int> logLimit{-1};

void LogSink::startup() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (started_) return;
    started_ = true;
    reference_ = os::TimeService::Instance()->getTicks();
    readEnvironment();
    openFile();
    updateLimits();
    announceStart();
}

void LogSink::shutdown() {
    drainer_.stop();
    std::lock_guard<std::mutex> lock(mutex_);
    if (!started_) return;
    drainLocked();
    note(Info, "logging ends");
    started_ = false;
    updateLimits();
    file_.close();
}

void LogSink::startDrain() { drainer_.start(); }

void LogSink::finish() {
    drainer_.stop();
    finished_ = true;
    {
        // The stream given to setConsole() may be gone by now.
        std::lock_guard<std::mutex> lock(mutex_);
        console_ = nullptr;
    }
    drain();
}

void LogSink::beforeFork() {
    drainer_.beforeFork();
    mutex_.lock();
}

void LogSink::afterFork(bool inChild) {
    if (inChild) queue_.clear();  // the parent writes its lines
    mutex_.unlock();
    drainer_.afterFork(inChild);
}

void LogSink::readEnvironment() {
    const char* const text = std::getenv("ORO_LOGLEVEL");
    levelGiven_ = false;
    problem_.clear();
    if (!text || !*text) return;
    char* end = nullptr;
    errno = 0;
    const long number = std::strtol(text, &end, 10);
    if (end == text || *end != '\0' || errno != 0) {
        problem_ = std::string("environment variable ORO_LOGLEVEL is '") + text +
                   "', expected a number from 0 (Never) to 6 (Debug)";
        return;
    }
    levelGiven_ = true;
    disabled_ = number < 0;
    // The variable cannot select RealTime: more than Debug means Debug.
    if (!disabled_) level_ = static_cast<LoggerLevel>(std::min<long>(number, Debug));
}

void LogSink::openFile() {
    const char* const name = std::getenv("ORO_LOGFILE");
    const bool given = name && *name;
    const char* const opened = given ? name : "orocos.log";
    // Logging that starts again must not delete earlier lines.
    fileProblem_.clear();
    if (!file_.open(opened, fileUsed_))
        fileProblem_ = std::string("no log file: '") + opened + "' cannot be written: " + os::detail::openError(errno) +
                       (given ? "" : "; ORO_LOGFILE names another one, /dev/null for none");
    fileUsed_ = true;
}

void LogSink::announceStart() {
    if (!problem_.empty())
        note(Error, problem_);
    else
        note(Info, levelGiven_ ? "log level taken from environment variable ORO_LOGLEVEL"
                               : "environment variable ORO_LOGLEVEL is not set");
    if (!fileProblem_.empty()) note(Warning, fileProblem_);
    if (file_.isShared()) note(Info, "the log file has lines of another process as well, which had it before");
    note(Info,
         "OROCOS version '" ORO_STRINGIFY(RTT_VERSION) "' compiled with " + compilerName() + ", running on GNU/Linux");
    note(Info, std::string("logging starts at level ") + levelTag(level()) + " (" + std::to_string(level()) + ")");
    note(Info,
         "reference time is " + std::to_string(referenceTime()) + " ticks; times in this log are seconds since then");
}

void LogSink::updateLimits() {
    const LoggerLevel level = this->level();
    int console = kNothing;
    int file = kNothing;
    if (started_ && !disabled_ && (level != RealTime || realTimeAllowed_)) {
        if (consoleEnabled_ && level != Never) console = level;
        if (fileEnabled_ && file_.isOpen()) file = std::max<int>(level, Info);
    }
    consoleLimit_ = console;
    fileLimit_ = file;
    logLimit = std::max(console, file);
}

void LogSink::setLevel(LoggerLevel level) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();  // earlier lines use the earlier settings; likewise below
    level_ = level;
    updateLimits();
}

void LogSink::setConsole(std::ostream& stream) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    console_ = &stream;
}

void LogSink::enableConsole(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    consoleEnabled_ = yes;
    updateLimits();
}

void LogSink::enableFile(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    fileEnabled_ = yes;
    updateLimits();
}

void LogSink::allowRealTime(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    realTimeAllowed_ = yes;
    updateLimits();
}

void LogSink::note(LoggerLevel level, const std::string& text) {
    writeLocked({now(), level, "Logger", text});
    flushLocked();
}

void LogSink::write(LoggerLevel level, std::string_view module, std::string_view text, bool flush, std::size_t cut) {
    writeNow({0, level, module, text, cut}, flush);
}

void LogSink::writeBare(LoggerLevel level, std::string_view text) {
    if (logMayReach(level)) writeNow({0, level, {}, text, 0, /*bare=*/true}, true);
}

void LogSink::writeNow(LogParts parts, bool flush) {
    if (os::inRealTimeThread() && !finished_.load(std::memory_order_relaxed)) return enqueue(parts);
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    parts.time = now();
    writeLocked(parts);
    if (flush || finished_) flushLocked();
}

void LogSink::enqueue(LoggerLevel level, std::string_view module, std::string_view text, std::size_t cut) noexcept {
    enqueue({0, level, module, text, cut});
}

void LogSink::enqueue(const LogParts& parts) noexcept {
    LogRecord record{};
    record.time = now();
    record.level = static_cast<std::uint8_t>(parts.level);
    record.bare = parts.bare;
    record.moduleSize = static_cast<std::uint16_t>(std::min(parts.module.size(), kLongestLogModule));
    const std::size_t size = std::min<std::size_t>(parts.text.size(), LogQueue::kLongest - record.moduleSize);
    record.textSize = static_cast<std::uint16_t>(size);
    record.cut = static_cast<std::uint32_t>(std::min<std::size_t>(parts.cut + parts.text.size() - size, UINT32_MAX));
    queue_.put(record, parts.module.data(), parts.text.data());
    drainer_.wake();
}

void LogSink::drain() {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    flushLocked();
}

namespace {

LogParts partsOf(const LogRecord& record, const char* bytes) {
    return {record.time,
            static_cast<LoggerLevel>(record.level),
            std::string_view(bytes, record.moduleSize),
            std::string_view(bytes + record.moduleSize, record.textSize),
            record.cut,
            record.bare};
}

/** The text about lost lines; uses a buffer, for signal handlers. */
std::string_view lostText(char (&out)[96], std::uint32_t lost) noexcept {
    char* const at = std::to_chars(out, out + 16, lost).ptr;
    constexpr std::string_view rest = " line(s) of real-time threads lost: the queue of the log was full";
    return {out, static_cast<std::size_t>(std::copy(rest.begin(), rest.end(), at) - out)};
}

}  // namespace

void LogSink::drainLocked() {
    LogRecord record;
    char bytes[LogQueue::kLongest];
    // Bounded, so that threads that log endlessly do not keep this thread here.
    for (std::uint32_t i = 0; i != LogQueue::kCells && queue_.take(record, bytes); ++i)
        writeLocked(partsOf(record, bytes));
    if (const std::uint32_t lost = queue_.takeLost()) {
        char text[96];
        writeLocked({now(), Warning, "Logger", lostText(text, lost)});
    }
}

void LogSink::drainDying() noexcept {
    // If the dying thread holds the mutex itself, the lines are lost.
    for (int attempt = 0; !mutex_.try_lock(); ++attempt) {
        if (attempt == 100) return;
        const timespec ms{0, 1000000};
        nanosleep(&ms, nullptr);
    }
    file_.flush();
    LogRecord record;
    char bytes[LogQueue::kLongest];
    char text[96];
    const bool toConsole = !console_ || console_ == &std::cerr || console_ == &std::clog;
    const auto show = [&](const LogParts& parts) {
        if (toConsole && reachesConsole(parts.level))
            composeLine(parts, [](const char* part, std::size_t size) { writeAll(STDERR_FILENO, part, size); });
        if (reachesFile(parts.level))
            composeLine(parts, [this](const char* part, std::size_t size) { file_.write(part, size); });
    };
    while (queue_.take(record, bytes)) show(partsOf(record, bytes));
    if (const std::uint32_t lost = queue_.takeLost()) show({now(), Warning, "Logger", lostText(text, lost)});
    file_.flush();
    mutex_.unlock();
}

void LogSink::writeLocked(const LogParts& parts) {
    if (!logMayReach(parts.level)) return;
    scratch_.clear();
    composeLine(parts, [this](const char* part, std::size_t size) { scratch_.append(part, size); });
    if (reachesConsole(parts.level)) {
        if (recent_.size() == kRecentLines) recent_.pop_front();
        recent_.emplace_back(scratch_, 0, scratch_.size() - 1);
        (console_ ? *console_ : std::cerr).write(scratch_.data(), static_cast<std::streamsize>(scratch_.size()));
    }
    if (reachesFile(parts.level)) file_.write(scratch_.data(), scratch_.size());
}

void LogSink::flush() {
    if (os::inRealTimeThread() && !finished_.load(std::memory_order_relaxed)) return;
    drain();
}

void LogSink::flushLocked() {
    if (consoleLimit_ != kNothing) (console_ ? *console_ : std::cerr).flush();
    file_.flush();
    const int failure = file_.takeFailure();
    if (failure != 0)
        note(Warning, std::string("the log file lacks lines that cannot be written: ") + std::strerror(failure));
}

std::string LogSink::takeLine() {
    std::lock_guard<std::mutex> lock(mutex_);
    drainLocked();
    if (recent_.empty()) return std::string();
    std::string line = std::move(recent_.front());
    recent_.pop_front();
    return line;
}

}  // namespace RTT::detail
