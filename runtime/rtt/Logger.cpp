// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Logger.hpp>

#include <rtt/LogReceiver.hpp>
#include <rtt/detail/log_line.hpp>
#include <rtt/detail/log_sink.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/internal/located_log.hpp>
#include <rtt/os/StartStopManager.hpp>
#include <rtt/os/log_hook.hpp>

#include <cstring>
#include <string_view>

/** @file The API of the log: << ─► line of this thread (detail/log_line) ─► sink of the process (detail/log_sink). */
namespace RTT {

using detail::logLine;
using detail::logMayReach;
using detail::logSink;

namespace {

void logFromOs(int number, const char* module, std::string_view text) {
    Logger::Instance();
    const auto level = static_cast<LoggerLevel>(number);
    if (logMayReach(level)) logSink().write(level, module, text, true);
}

/** Prepares a new thread to log and to use ports as a real-time thread. */
void prepareRealTimeThread() {
    Logger::Instance();
    logSink().startDrain();
    logLine();
    const internal::Reclaimer::Guard record;  // takes the thread's record
}

int startLogging() {
    Logger::Instance()->startup();
    logSink().startDrain();
    return 0;
}

// When the library is loaded, because a thread may be created before the first use of the log.
const bool hooked = (os::setLogHook(&logFromOs), os::setRealTimeThreadHook(&prepareRealTimeThread), true);
os::InitFunction onStart(&startLogging, os::StartLogging);
os::CleanupFunction onStop(&Logger::Release, os::StopLogging);

/** By then static objects of programs and plugins are gone, and some of those of this library. */
const struct AtExit {
    ~AtExit() { logSink().finish(); }
} atExit;

}  // namespace

Logger::In::In(const std::string& module) { enter(module.data(), module.size()); }
Logger::In::In(const char* module) { enter(module, std::strlen(module)); }

void Logger::In::enter(const char* module, std::size_t size) noexcept {
    detail::LogLine& line = logLine();
    std::strcpy(previous_, line.module);
    previousDepth_ = line.depth;
    line.setModule(module, size);
}

Logger::In::~In() {
    detail::LogLine& line = logLine();
    line.setModule(previous_, std::strlen(previous_));
    line.depth = previousDepth_;
}

Logger* Logger::Instance() {
    static Logger* const instance = [] {
        static Logger logger;  // has no state of its own
        logger.startup();
        return &logger;
    }();
    return instance;
}

Logger* Logger::Instance(std::ostream& console) {
    logSink().setConsole(console);
    return Instance();
}

void Logger::Release() { logSink().shutdown(); }

Logger& Logger::log() { return *Instance(); }

Logger& Logger::log(LogLevel level) {
    logLine().level = level;
    return *Instance();
}

std::ostream& Logger::endl(std::ostream& s) { return s << std::endl; }
std::ostream& Logger::nl(std::ostream& s) { return s << '\n'; }
std::ostream& Logger::flush(std::ostream& s) { return s << std::flush; }

std::ostream* Logger::openLine() {
    detail::LogLine& line = logLine();
    if (!logMayReach(line.level)) return nullptr;
    line.opened = true;
    return &line.stream;
}

Logger& Logger::operator<<(const char* text) {
    if (std::ostream* line = openLine()) *line << (text ? text : "(null)");
    return *this;
}

Logger& Logger::operator<<(const std::string& text) {
    if (std::ostream* line = openLine()) *line << text;
    return *this;
}

Logger& Logger::operator<<(LogLevel level) {
    logLine().level = level;
    return *this;
}

Logger& Logger::operator<<(LogFunction manipulator) {
    if (manipulator == static_cast<LogFunction>(&Logger::endl))
        logendl();
    else if (manipulator == static_cast<LogFunction>(&Logger::nl))
        lognl();
    else if (manipulator == static_cast<LogFunction>(&Logger::flush))
        logflush();
    else if (std::ostream* line = openLine())
        manipulator(*line);
    return *this;
}

void Logger::logendl() { logLine().finish(true); }
void Logger::lognl() { logLine().finish(false); }
void Logger::logflush() { logSink().flush(); }

Logger& Logger::in(const std::string& module) {
    logLine().setModule(module.data(), module.size());
    return *this;
}

Logger& Logger::out(const std::string& previousModule) {
    detail::LogLine& line = logLine();
    line.depth = detail::LogLine::kNoModule;
    // A name that the thread would have anyway is not made its module, or it would outlast a component's hook.
    return getLogModule() == previousModule ? *this : in(previousModule);
}

std::string Logger::getLogModule() const {
    char room[detail::kLongestThreadName];
    return std::string(logLine().origin(room));
}

void Logger::setLogLevel(LogLevel level) { logSink().setLevel(level); }
Logger::LogLevel Logger::getLogLevel() const { return logSink().level(); }
void Logger::setStdStream(std::ostream& stream) { logSink().setConsole(stream); }

bool Logger::mayLog() const { return logMayReach(logLine().level); }
bool Logger::mayLogStdOut() const { return logSink().reachesConsole(logLine().level); }
bool Logger::mayLogFile() const { return logSink().reachesFile(logLine().level); }
void Logger::mayLogStdOut(bool yes) { logSink().enableConsole(yes); }
void Logger::mayLogFile(bool yes) { logSink().enableFile(yes); }

void Logger::allowRealTime() {
    logSink().write(Warning, "Logger", "log messages of real-time code are allowed now", true);
    logSink().allowRealTime(true);
}

void Logger::disallowRealTime() {
    logSink().write(Warning, "Logger", "log messages of real-time code are not allowed any more", true);
    logSink().allowRealTime(false);
}

std::string Logger::getLogLine() { return logSink().takeLine(); }
os::TimeService::ticks Logger::getReferenceTime() const { return logSink().referenceTime(); }
void Logger::setReferenceTime(os::TimeService::ticks reference) { logSink().setReferenceTime(reference); }

void Logger::setLogTime(LogTime time) { logSink().setTime(time); }
LogTime Logger::getLogTime() { return logSink().time(); }

LogReceiver* Logger::setReceiver(LogReceiver* receiver, LogReceiverUse use) {
    return logSink().setReceiver(receiver, use);
}

LogReceiver::~LogReceiver() = default;

void Logger::startup() { logSink().startup(); }
void Logger::shutdown() { logSink().shutdown(); }

void internal::logLocated(LoggerLevel level, const std::string& text) {
    Logger::Instance();
    logSink().writeBare(level, text);
}

}  // namespace RTT
