// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_ros/detail/master.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace rtt_ros::detail {
namespace {

constexpr std::size_t kLongestAnswer = 4096;  // a master needs 300

using Clock = std::chrono::steady_clock;

int millisecondsUntil(Clock::time_point end) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    return static_cast<int>(std::max<long long>(left, 0));
}

/** Looks up a host in the background, because getaddrinfo() may wait for a name server for many seconds. */
class Lookup {
public:
    Lookup(const std::string& host, unsigned port) : kept_(new Kept{host, std::to_string(port), {}, {}}) {
        kept_->hints.ai_socktype = SOCK_STREAM;
        kept_->request.ar_name = kept_->host.c_str();
        kept_->request.ar_service = kept_->service.c_str();
        kept_->request.ar_request = &kept_->hints;
    }
    ~Lookup() {
        // A request that is being processed cannot be cancelled: its memory is left to it.
        if (gai_error(&kept_->request) == EAI_INPROGRESS && gai_cancel(&kept_->request) != EAI_CANCELED) return;
        if (kept_->request.ar_result) freeaddrinfo(kept_->request.ar_result);
        delete kept_;
    }
    Lookup(const Lookup&) = delete;
    Lookup& operator=(const Lookup&) = delete;

    /** The addresses; null with the reason. */
    const addrinfo* wait(Clock::time_point end, std::string& why) {
        gaicb* list[] = {&kept_->request};
        int status = getaddrinfo_a(GAI_NOWAIT, list, 1, nullptr);
        while (status == 0 && gai_error(&kept_->request) == EAI_INPROGRESS) {
            const int left = millisecondsUntil(end);
            const timespec time = {left / 1000, left % 1000 * 1000000L};
            if (gai_suspend(list, 1, &time) == EAI_AGAIN) {
                why = "its address was not found in time";
                return nullptr;
            }
        }
        if (status == 0) status = gai_error(&kept_->request);
        if (status != 0) why = gai_strerror(status);
        return status == 0 ? kept_->request.ar_result : nullptr;
    }

private:
    struct Kept {
        std::string host, service;
        addrinfo hints;
        gaicb request;
    };
    Kept* kept_;
};

class Socket {
public:
    explicit Socket(const addrinfo& address)
        : fd_(socket(address.ai_family, address.ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, address.ai_protocol)) {}
    ~Socket() {
        if (fd_ >= 0) close(fd_);
    }
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;

    bool connectTo(const addrinfo& address, Clock::time_point end) {
        if (fd_ < 0) return false;
        if (connect(fd_, address.ai_addr, address.ai_addrlen) == 0) return true;
        if (errno != EINPROGRESS || !wait(POLLOUT, end)) return false;
        int error = 0;
        socklen_t size = sizeof error;
        if (getsockopt(fd_, SOL_SOCKET, SO_ERROR, &error, &size) == 0) errno = error;
        return errno == 0;
    }

    /** True if the answer is one of XML-RPC. Other programs and proxies answer, too, and roscpp would wait for more. */
    bool ask(const std::string& question, Clock::time_point end) {
        if (send(fd_, question.data(), question.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(question.size()))
            return false;
        std::string answer;
        while (answer.size() < kLongestAnswer && answer.find("<methodResponse>") == std::string::npos) {
            char block[512];
            if (!wait(POLLIN, end)) return false;
            const ssize_t got = recv(fd_, block, sizeof block, 0);
            if (got < 0) return false;
            if (got == 0) break;
            answer.append(block, static_cast<std::size_t>(got));
        }
        errno = EPROTO;
        return answer.find("<methodResponse>") != std::string::npos;
    }

private:
    bool wait(short events, Clock::time_point end) {
        pollfd one = {fd_, events, 0};
        int ready = 0;
        do {
            ready = poll(&one, 1, millisecondsUntil(end));
        } while (ready < 0 && errno == EINTR);
        if (ready == 0) errno = ETIMEDOUT;
        return ready > 0;
    }

    const int fd_;
};

std::string callOf(const std::string& host) {
    const std::string body =
        "<?xml version=\"1.0\"?><methodCall><methodName>getPid</methodName>"
        "<params><param><value>/rtt</value></param></params></methodCall>";
    return "POST / HTTP/1.1\r\nHost: " + host + "\r\nContent-Type: text/xml\r\nConnection: close\r\nContent-Length: " +
           std::to_string(body.size()) + "\r\n\r\n" + body;
}

}  // namespace

std::string whyMasterIsSilent(const std::string& host, unsigned port, std::chrono::milliseconds limit) {
    const Clock::time_point end = Clock::now() + limit;
    std::string why;
    Lookup lookup(host, port);
    for (const addrinfo* address = lookup.wait(end, why); address; address = address->ai_next) {
        Socket one(*address);
        if (one.connectTo(*address, end) && one.ask(callOf(host), end)) return {};
        why = errno == EPROTO ? "what answers there is no ROS master" : std::strerror(errno);
    }
    return why.empty() ? "it has no address" : why;
}

}  // namespace rtt_ros::detail
