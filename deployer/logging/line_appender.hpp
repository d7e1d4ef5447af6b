// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Appenders of log4cpp that write records: a layout makes the text, a derived class takes it to its place.
#ifndef OROFORGE_LOGGING_LINE_APPENDER_HPP
#define OROFORGE_LOGGING_LINE_APPENDER_HPP

#include <log4cpp/LayoutAppender.hh>

#include <cstddef>
#include <string>

namespace OCL::logging {

/** For one thread. Failures go to the log once, until writing succeeds again; what is lost is counted. */
class LineAppender : public log4cpp::LayoutAppender {
public:
    /** `owner` is the component, for messages. */
    explicit LineAppender(const std::string& owner) : log4cpp::LayoutAppender(owner), owner_(owner) {}

    /** Writes what is kept back. The component calls it at the end of each cycle. */
    virtual void flush() = 0;
    /** Events that could not be written. */
    unsigned long lostEvents() const { return lost_; }
    /** Reports a failure that lasts, because the component stops. */
    void reportLost();

protected:
    void _append(const log4cpp::LoggingEvent& event) override;
    /** Takes a record, which ends with a line end. */
    virtual void write(const log4cpp::LoggingEvent& event, const std::string& record) = 0;
    /** What it writes to, for messages: "file 'x.log'". */
    virtual std::string target() const = 0;

    void failed(std::size_t events, const std::string& reason);
    void succeeded();

private:
    const std::string owner_;
    unsigned long lost_ = 0, lostNow_ = 0;
    bool fails_ = false;
};

}  // namespace OCL::logging

#endif
