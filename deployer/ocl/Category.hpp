// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_CATEGORY_HPP
#define ORO_OCL_CATEGORY_HPP

#include <log4cpp/Category.hh>
#include <ocl/CategoryStream.hpp>
#include <ocl/LoggingEvent.hpp>
#include <rtt/OutputPort.hpp>

#include <atomic>
#include <cstdarg>
#include <cstddef>
#include <string>

namespace OCL {
namespace logging {

class LoggingService;
class RuntimeLog;

// The formats of log4cpp::Category::log() are hidden on purpose: a '%' in a message is a '%'.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Woverloaded-virtual"

/**
 * A category of log4cpp that sends its messages to appenders through a port, so that real-time threads may log:
 *
 *     auto* category = dynamic_cast<OCL::logging::Category*>(&log4cpp::Category::getInstance("robot.arm"));
 *     category->info("homed");
 *
 * log() and all that calls it may be called from any thread. They do not block, lock or allocate if the message has no
 * more characters than the LoggingService has reserved (MessageSize), and no port connection uses a lock. Longer
 * messages take memory from the pool of <rtt/os/oro_malloc.h>. A message for which the buffer of an appender has no
 * room is dropped for that appender, which counts and reports it.
 *
 * Functions of log4cpp::Category itself (std::string, printf formats) reach the same appenders, and besides those of
 * log4cpp that are attached to the category. They allocate and lock.
 *
 * Categories exist until the end of the process.
 */
class OCL_API Category : public log4cpp::Category {
public:
    typedef log4cpp::Category* (*Factory)(const std::string& name, log4cpp::Category* parent,
                                          log4cpp::Priority::Value priority);

    /**
     * From now on log4cpp::Category::getInstance() makes new categories with this function. Existing ones stay as they
     * are; call it first in main(), before other threads use log4cpp, so that there are none. False, with an error
     * logged, if this version of log4cpp does not allow that. The deployers call it, and so does a LoggingService.
     */
    static bool installFactory(Factory factory = &Category::createOCLCategory);
    /** A category of this class. log4cpp owns it. */
    static log4cpp::Category* createOCLCategory(const std::string& name, log4cpp::Category* parent,
                                                log4cpp::Priority::Value priority);

    ~Category() override;

    /** A port that knows the category whose events it sends. */
    class OCL_API Port : public RTT::OutputPort<LoggingEvent> {
    public:
        explicit Port(const std::string& category);
        const std::string category;
    };

    /** All messages come through this function, also those of the streams and of log4cpp's own functions: override it
        in a class of your own. Does nothing if the category's priority leaves the message out. */
    virtual void log(log4cpp::Priority::Value priority, const char* text, std::size_t size) noexcept;
    virtual void log(log4cpp::Priority::Value priority, const RTT::rt_string& message) noexcept;
    void log(log4cpp::Priority::Value priority, const char* message) noexcept;

#define ORO_LOG_METHODS(name, priority)                                                              \
    void name(const RTT::rt_string& message) noexcept { log(log4cpp::Priority::priority, message); } \
    void name(const char* message) noexcept { log(log4cpp::Priority::priority, message); }
    ORO_LOG_METHODS(debug, DEBUG)
    ORO_LOG_METHODS(info, INFO)
    ORO_LOG_METHODS(notice, NOTICE)
    ORO_LOG_METHODS(warn, WARN)
    ORO_LOG_METHODS(error, ERROR)
    ORO_LOG_METHODS(crit, CRIT)
    ORO_LOG_METHODS(alert, ALERT)
    ORO_LOG_METHODS(emerg, EMERG)
    ORO_LOG_METHODS(fatal, FATAL)
#undef ORO_LOG_METHODS

    /** A stream of one message; one that ignores all if the category leaves out that priority. */
    CategoryStream getRTStream(log4cpp::Priority::Value priority) noexcept;

    /** How many messages of all categories were lost because too many threads were inside log() at once. */
    static unsigned long lostMessages() noexcept;

protected:
    Category(const std::string& name, log4cpp::Category* parent,
             log4cpp::Priority::Value priority = log4cpp::Priority::NOTSET);

    /** Not public: making a std::string allocates. */
    void log(log4cpp::Priority::Value priority, const std::string& message) noexcept override;
    using log4cpp::Category::callAppenders;
    /** Writes the event to the port and, with additivity, to those of the parents that are of this class. */
    virtual void callAppenders(const LoggingEvent& event) noexcept;

    void _logUnconditionally(log4cpp::Priority::Value priority, const char* format,
                             va_list arguments) noexcept override;
    void _logUnconditionally2(log4cpp::Priority::Value priority, const std::string& message) noexcept override;

    Port log_port;

private:
    friend class LoggingService;
    friend class RuntimeLog;
    friend class Appender;
    bool isHeard() const noexcept;

    Category* const parent_;  // null if the parent is of another class
    RTT::rt_string rtName_;
};

#pragma GCC diagnostic pop

}  // namespace logging
}  // namespace OCL

#endif
