// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_sink.hpp>

#include <rtt/detail/log_format.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <iostream>

namespace RTT {
namespace detail {

namespace {
constexpr std::size_t kRecentLines = 1000;
}

LogSink& logSink() {
    static LogSink& sink = *new LogSink;
    return sink;
}

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
    std::lock_guard<std::mutex> lock(mutex_);
    if (!started_) return;
    note(Info, "logging ends");
    started_ = false;
    updateLimits();
    if (file_) std::fclose(file_);
    file_ = nullptr;
}

void LogSink::readEnvironment() {
    const char* const text = std::getenv("ORO_LOGLEVEL");
    levelGiven_ = false;
    problem_.clear();
    if (!text) return;
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
    // RealTime cannot be asked for here: more than Debug means Debug.
    if (!disabled_) level_ = static_cast<LoggerLevel>(std::min<long>(number, Debug));
}

void LogSink::openFile() {
    const char* const name = std::getenv("ORO_LOGFILE");
    // 'e': programs that this process starts do not get it. Not openable: no file, and no message about it.
    file_ = std::fopen(name && *name ? name : "orocos.log", fileUsed_ ? "ae" : "we");
    fileUsed_ = true;  // logging that starts again must not delete what was logged before
}

void LogSink::announceStart() {
    if (!problem_.empty())
        note(Error, problem_);
    else
        note(Info, levelGiven_ ? "log level taken from environment variable ORO_LOGLEVEL"
                               : "environment variable ORO_LOGLEVEL is not set");
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
        if (fileEnabled_ && file_) file = std::max<int>(level, Info);
    }
    consoleLimit_ = console;
    fileLimit_ = file;
    limit_ = std::max(console, file);
}

void LogSink::setLevel(LoggerLevel level) {
    std::lock_guard<std::mutex> lock(mutex_);
    level_ = level;
    updateLimits();
}

void LogSink::setConsole(std::ostream& stream) {
    std::lock_guard<std::mutex> lock(mutex_);
    console_ = &stream;
}

void LogSink::enableConsole(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    consoleEnabled_ = yes;
    updateLimits();
}

void LogSink::enableFile(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    fileEnabled_ = yes;
    updateLimits();
}

void LogSink::allowRealTime(bool yes) {
    std::lock_guard<std::mutex> lock(mutex_);
    realTimeAllowed_ = yes;
    updateLimits();
}

void LogSink::note(LoggerLevel level, const std::string& text) { writeLocked(level, "Logger", text, true); }

void LogSink::write(LoggerLevel level, const std::string& module, const std::string& text, bool flush) {
    std::lock_guard<std::mutex> lock(mutex_);
    writeLocked(level, module, text, flush);
}

void LogSink::writeLocked(LoggerLevel level, const std::string& module, const std::string& text, bool flush) {
    if (!mayLog(level)) return;
    formatLine(scratch_, os::TimeService::Instance()->getTicks(referenceTime()), level, module, text);
    if (reachesConsole(level)) {
        if (recent_.size() == kRecentLines) recent_.pop_front();
        recent_.push_back(scratch_);
    }
    scratch_ += '\n';
    if (reachesConsole(level))
        (console_ ? *console_ : std::cerr).write(scratch_.data(), static_cast<std::streamsize>(scratch_.size()));
    if (file_ && reachesFile(level)) std::fwrite(scratch_.data(), 1, scratch_.size(), file_);
    if (flush) flushLocked();
}

void LogSink::flush() {
    std::lock_guard<std::mutex> lock(mutex_);
    flushLocked();
}

void LogSink::flushLocked() {
    if (consoleLimit_ != kNothing) (console_ ? *console_ : std::cerr).flush();
    if (file_) std::fflush(file_);
}

std::string LogSink::takeLine() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (recent_.empty()) return std::string();
    std::string line = std::move(recent_.front());
    recent_.pop_front();
    return line;
}

}  // namespace detail
}  // namespace RTT
