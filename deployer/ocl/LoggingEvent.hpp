// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_LOGGING_EVENT_HPP
#define ORO_OCL_LOGGING_EVENT_HPP

#include <log4cpp/LoggingEvent.hh>
#include <log4cpp/Priority.hh>
#include <log4cpp/TimeStamp.hh>
#include <ocl/OCL.hpp>
#include <rtt/rt_string.hpp>
#include <rtt/rtt-config.h>

#include <cstddef>

namespace OCL {
namespace logging {

/**
 * What a category sends to appenders: one message with its place and time. The texts lie in real-time memory.
 *
 * Assigning one keeps the memory of the target: texts that fit into it need no other, so no allocation and no lock.
 * Longer ones are allocated from the pool of <rtt/os/oro_malloc.h>. Where that is used up, the text is cut, which the
 * event says itself and cutTexts() counts. The default constructor allocates nothing; copying throws std::bad_alloc.
 */
struct OCL_API LoggingEvent {
    LoggingEvent() = default;
    /** An event of this thread, now. */
    LoggingEvent(const RTT::rt_string& category, const RTT::rt_string& message, const RTT::rt_string& ndc,
                 log4cpp::Priority::Value priority);
    LoggingEvent(const LoggingEvent& other) = default;
    LoggingEvent& operator=(const LoggingEvent& other) noexcept;

    /** The same event for appenders and layouts of log4cpp. Not real-time safe. */
    log4cpp::LoggingEvent toLog4cpp() const;

    /** Reserves real-time memory for texts of that many characters; throws std::bad_alloc. */
    void reserve(std::size_t categoryName, std::size_t message);
    /** Set the texts as assigning does; set thread and time to those of the caller. Real-time safe in that sense. */
    void setCategory(const RTT::rt_string& name) noexcept;
    void setMessage(const char* text, std::size_t size) noexcept;
    void setOrigin() noexcept;

    /** How many texts were cut in this process because real-time memory is used up. */
    static unsigned long cutTexts() noexcept;

    RTT::rt_string categoryName;
    RTT::rt_string message;
    RTT::rt_string ndc;  ///< the nested diagnostic context; empty
    log4cpp::Priority::Value priority = log4cpp::Priority::NOTSET;
    RTT::rt_string threadName;           ///< the name that the system has of the thread
    log4cpp::TimeStamp timeStamp{0, 0};  ///< of the wall clock
};

/** Adds the type LoggingEvent to the type system, for scripts, displays and reports. More calls do nothing. The library
    `ocl` does that when it is imported. Not real-time safe. */
OCL_API bool addLoggingTypes();

}  // namespace logging
}  // namespace OCL

#endif
