// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Events to the daemon of the system's log.
#ifndef OROFORGE_LOGGING_SYSLOG_LINES_HPP
#define OROFORGE_LOGGING_SYSLOG_LINES_HPP

#include "line_appender.hpp"

#include <optional>
#include <string>

namespace OCL::logging {

/** The number of a facility by its name; none if there is no such facility. */
std::optional<int> facilityOf(const std::string& name);

/**
 * Sends what syslog(3) sends. That function itself has one identity per process, and does not tell whether a message
 * arrived.
 */
class SyslogLines final : public LineAppender {
public:
    SyslogLines(const std::string& owner, std::string identity, int facility, std::string socket);
    ~SyslogLines() override;
    void flush() override {}

private:
    void write(const log4cpp::LoggingEvent& event, const std::string& record) override;
    std::string target() const override { return "the system's log at '" + path_ + "'"; }
    void close() override;
    bool send(const std::string& datagram, std::string& error);
    bool connect(std::string& error);

    const std::string identity_, path_;
    const int facility_;
    int socket_ = -1;
};

}  // namespace OCL::logging

#endif
