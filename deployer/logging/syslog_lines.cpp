// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "syslog_lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <cstdio>
#include <ctime>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <syslog.h>
#include <unistd.h>
#include <utility>

namespace OCL::logging {
namespace {

constexpr int kPatience = 1000;  // milliseconds that a busy daemon is waited for

const struct {
    const char* name;
    int number;
} kFacilities[] = {
    {"kern", LOG_KERN},     {"user", LOG_USER},     {"mail", LOG_MAIL},     {"daemon", LOG_DAEMON},
    {"auth", LOG_AUTH},     {"syslog", LOG_SYSLOG}, {"lpr", LOG_LPR},       {"news", LOG_NEWS},
    {"uucp", LOG_UUCP},     {"cron", LOG_CRON},     {"local0", LOG_LOCAL0}, {"local1", LOG_LOCAL1},
    {"local2", LOG_LOCAL2}, {"local3", LOG_LOCAL3}, {"local4", LOG_LOCAL4}, {"local5", LOG_LOCAL5},
    {"local6", LOG_LOCAL6}, {"local7", LOG_LOCAL7},
};

/** Priorities of log4cpp are a hundred times those of the system. */
int levelOf(log4cpp::Priority::Value priority) { return std::max(LOG_EMERG, std::min(priority / 100, LOG_DEBUG)); }

/** As in RFC 3164, in local time. */
std::string timeText(const log4cpp::TimeStamp& time) {
    static const char* const kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                          "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    const std::time_t seconds = static_cast<unsigned>(time.getSeconds());
    std::tm parts{};
    ::localtime_r(&seconds, &parts);
    char text[64];
    std::snprintf(text, sizeof text, "%s %2d %02d:%02d:%02d", kMonths[parts.tm_mon % 12], parts.tm_mday, parts.tm_hour,
                  parts.tm_min, parts.tm_sec);
    return text;
}

}  // namespace

std::optional<int> facilityOf(const std::string& name) {
    for (const auto& facility : kFacilities)
        if (name == facility.name) return facility.number;
    return std::nullopt;
}

SyslogLines::SyslogLines(const std::string& owner, std::string identity, int facility, std::string socket)
    : LineAppender(owner), identity_(std::move(identity)), path_(std::move(socket)), facility_(facility) {}

SyslogLines::~SyslogLines() { close(); }

void SyslogLines::close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
}

bool SyslogLines::connect(std::string& error) {
    if (socket_ >= 0) return true;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path_.size() >= sizeof address.sun_path) {
        error = "the name of the socket is too long";
        return false;
    }
    std::memcpy(address.sun_path, path_.data(), path_.size());
    socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket_ >= 0 && ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
        return true;
    error = std::strerror(errno);
    close();
    return false;
}

bool SyslogLines::send(const std::string& datagram, std::string& error) {
    for (int attempt = 0; attempt != 2; ++attempt) {
        if (!connect(error)) return false;
        ssize_t done = ::send(socket_, datagram.data(), datagram.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        pollfd wait{socket_, POLLOUT, 0};
        if (done < 0 && errno == EAGAIN && ::poll(&wait, 1, kPatience) > 0)
            done = ::send(socket_, datagram.data(), datagram.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        if (done >= 0) return true;
        error = std::strerror(errno);
        const bool gone = errno == ECONNREFUSED || errno == ENOTCONN || errno == ECONNRESET;
        if (!gone) return false;
        close();  // the daemon may have begun anew
    }
    return false;
}

void SyslogLines::write(const log4cpp::LoggingEvent& event, const std::string& record) {
    std::string text = record.substr(0, record.find_last_not_of('\n') + 1);
    std::string error;
    const std::string datagram = "<" + std::to_string(facility_ | levelOf(event.priority)) + ">" +
                                 timeText(event.timeStamp) + " " + identity_ + "[" + std::to_string(::getpid()) +
                                 "]: " + text;
    if (send(datagram, error))
        succeeded();
    else
        failed(1, error);
}

}  // namespace OCL::logging
