// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_LOGGER_HPP
#define ORO_LOGGER_HPP

#include <rtt/os/MutexLock.hpp>  // users take it from here
#include <rtt/os/TimeService.hpp>
#include <rtt/rtt-config.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

namespace RTT {

// Without this, code in this namespace that takes a logarithm would find only the functions below.
using std::log;

/** Severity of a message; smaller is worse. */
enum LoggerLevel { Never = 0, Fatal = 1, Critical = 2, Error = 3, Warning = 4, Info = 5, Debug = 6, RealTime = 7 };

/** How lines show when they were logged. */
enum class LogTime {
    Relative, /**< seconds since the reference time: `12.345` */
    Wall      /**< local time by ISO 8601: `2026-03-29T14:37:49.123+02:00` */
};

class LogReceiver;
/** What the file gets while there is a LogReceiver. */
enum class LogReceiverUse { BesideFile, InsteadOfFile };

namespace detail {
constexpr std::size_t kLongestLogModule = 255;
}

/**
 * The log of the process: `log(Error) << "what happened" << endlog();`
 *
 * The console (std::cerr) shows lines up to the log level (default Warning), the file `orocos.log` those up to Info or
 * the log level, whichever is more. The first use starts logging. Environment at start-up:
 *
 *   ORO_LOGLEVEL      number; negative: no logging at all
 *   ORO_LOGTIME       relative (default) or wall, see LogTime
 *   ORO_LOGCOLOR      auto (default), never or always: colours of the levels on std::cerr. Automatically they are on if
 *                     that is a terminal, NO_COLOR is not set and TERM is not "dumb"
 *   ORO_LOGFILE       file name
 *   ORO_LOGFILE_KEEP  how many earlier files stay, as orocos.log.1 (the latest) and so on; default 3; 0: none
 *   ORO_LOGFILE_MAX   bytes, with k, m or g for units: a file that would grow beyond becomes orocos.log.1 as well
 *
 * A process that finds its file used by another living process writes `orocos-<process id>.log` instead.
 *
 * A line is `<time> [ LEVEL ][origin] text`. The origin is the module of the innermost Logger::In; but within a hook,
 * operation, port callback, function or script that a component executes meanwhile in this thread, the name of that
 * component. An operation that its caller's thread executes counts as the caller's. Without both, it is the name of the
 * thread: "main", the name that it was given, or "thread <id>".
 *
 * Every thread composes its own line, with its own level and module name; a finished line is passed on as a whole, so
 * lines of several threads never mix. A message below both levels costs one comparison per `<<`.
 *
 * A line is written before endlog() returns, unless its thread is scheduled as a real-time thread at that moment: it
 * then puts the line into a queue, without allocating or waiting, and a thread of ordinary priority writes it. That
 * thread exists from __os_init(), or the first real-time os::Thread; without it, the next line of an ordinary thread or
 * the end of the process writes the queue.
 * All log(), <<, In, endlog() and nlog() are real-time safe there, unless an operator<< of a type is not.
 * A line of a real-time thread is cut after about 1700 characters, and says so; lines for which the queue (at least 64
 * lines) has no room are counted, and a warning gives the number.
 */
class RTT_API Logger {
public:
    typedef LoggerLevel LogLevel;
    static constexpr LogLevel Never = RTT::Never;
    static constexpr LogLevel Fatal = RTT::Fatal;
    static constexpr LogLevel Critical = RTT::Critical;
    static constexpr LogLevel Error = RTT::Error;
    static constexpr LogLevel Warning = RTT::Warning;
    static constexpr LogLevel Info = RTT::Info;
    static constexpr LogLevel Debug = RTT::Debug;
    static constexpr LogLevel RealTime = RTT::RealTime;

    /** Names the module of this thread's messages until the end of the scope, by up to 255 characters. */
    class RTT_API In {
    public:
        explicit In(const std::string& module);
        /** Allocates nothing. */
        explicit In(const char* module);
        ~In();
        In(const In&) = delete;
        In& operator=(const In&) = delete;

    private:
        void enter(const char* module, std::size_t size) noexcept;
        char previous_[detail::kLongestLogModule + 1];
        int previousDepth_;  // as in detail::LogLine
    };

    static Logger& log();
    /** Sets the level of this thread's current line, and of its next ones. */
    static Logger& log(LogLevel level);
    /** Starts logging if necessary. The argument sets the console stream. */
    static Logger* Instance();
    static Logger* Instance(std::ostream& console);
    /** Ends logging, like shutdown(). The instance stays valid. */
    static void Release();

    /** Ends the line and flushes. On another stream: std::endl. */
    static std::ostream& endl(std::ostream& s);
    /** Ends the line. On another stream: a newline. */
    static std::ostream& nl(std::ostream& s);
    static std::ostream& flush(std::ostream& s);
    typedef std::ostream& (*LogFunction)(std::ostream&);

    template <class T>
    Logger& operator<<(const T& value) {
        if (std::ostream* line = openLine()) *line << value;
        return *this;
    }
    Logger& operator<<(const char* text);
    Logger& operator<<(const std::string& text);
    /** Sets the level of this thread's current line. */
    Logger& operator<<(LogLevel level);
    /** Logger::endl, Logger::nl, Logger::flush, or a manipulator of the text stream. */
    Logger& operator<<(LogFunction manipulator);

    /** These end the line of this thread; logendl() also flushes. */
    void logendl();
    void lognl();
    void logflush();

    /** Sets the module of this thread's messages until the next in() or out(). Prefer Logger::In. */
    Logger& in(const std::string& module);
    /** Ends in(), with the earlier result of getLogModule(). */
    Logger& out(const std::string& previousModule);
    /** The origin that a line of this thread has now. */
    std::string getLogModule() const;

    void setLogLevel(LogLevel level);
    LogLevel getLogLevel() const;
    /** Sets the console stream, which must outlive its use. Default: std::cerr. Earlier lines of real-time threads go
        to the previous one. */
    void setStdStream(std::ostream& stream);
    /** True if the level of this thread's current line reaches the console or the file. */
    bool mayLog() const;
    bool mayLogStdOut() const;
    bool mayLogFile() const;
    /** These switch the console and the file on or off. */
    void mayLogStdOut(bool yes);
    void mayLogFile(bool yes);
    /** Without this, the log level RealTime silences everything. */
    void allowRealTime();
    void disallowRealTime();

    /** Removes and returns the oldest of the last 1000 lines of the console, without its end of line. */
    std::string getLogLine();
    /** The ticks at which logging started, the zero of the time in the lines. */
    os::TimeService::ticks getReferenceTime() const;
    /** Lines show the time since then. Any thread; for a simulation that sets the time of os::TimeService. */
    void setReferenceTime(os::TimeService::ticks reference);

    /** Takes precedence over ORO_LOGTIME. Any thread, also before the first use of the log, which it does not start. */
    static void setLogTime(LogTime time);
    static LogTime getLogTime();

    /**
     * From now on, hands each line that is meant for the file to `receiver`, in a thread of its own. Null: to none.
     * Returns the previous receiver, which may be destroyed then: it has got the lines that were logged before, unless
     * that took more than a second, and is not being called any more, unless its own receive() calls this. Any thread,
     * but not one that holds a lock that receive() takes, and not a real-time thread: waits for the end of receive().
     * A child of fork() has no receiver at first. When the runtime ends, a receiver has a second to take the rest.
     */
    LogReceiver* setReceiver(LogReceiver* receiver, LogReceiverUse use = LogReceiverUse::BesideFile);

    void startup();
    void shutdown();

private:
    Logger() = default;
    std::ostream* openLine();
};

/** The log. */
inline Logger& log() { return Logger::log(); }
inline Logger& log(LoggerLevel level) { return Logger::log(level); }
/** Ends a line and flushes. */
inline Logger::LogFunction endlog() { return Logger::endl; }
/** Ends a line with this level. */
inline Logger::LogFunction endlog(LoggerLevel level) {
    Logger::log(level);
    return Logger::endl;
}
/** Ends a line; the next one has the same level. */
inline Logger::LogFunction nlog() { return Logger::nl; }
inline Logger::LogFunction flushlog() { return Logger::flush; }

}  // namespace RTT
#endif
