// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A client of TcpReporting for tests: a plain blocking socket with a time limit.
#ifndef OROFORGE_TESTS_COMPONENTS_TCP_PEER_HPP
#define OROFORGE_TESTS_COMPONENTS_TCP_PEER_HPP

#include <arpa/inet.h>
#include <cstddef>
#include <netinet/in.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

namespace components_test {

class TcpPeer {
public:
    /** @param room of the socket for what comes in; 0: that of the system */
    explicit TcpPeer(unsigned int port, int room = 0, int seconds = 10)
        : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        if (room != 0) (void)::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
        const timeval limit{seconds, 0};
        (void)::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        (void)::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_port = htons(static_cast<unsigned short>(port));
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0;
    }
    ~TcpPeer() { ::close(socket_); }
    TcpPeer(const TcpPeer&) = delete;
    TcpPeer& operator=(const TcpPeer&) = delete;

    bool connected() const { return connected_; }
    bool send(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (count <= 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(count));
        }
        return true;
    }
    /** Nothing more comes from here. */
    void endOutput() { (void)::shutdown(socket_, SHUT_WR); }
    /** The next line without its end; "(end)" at the end of the connection, "(silence)" if nothing comes in time. */
    std::string line() {
        for (;;) {
            const std::size_t end = read_.find('\n', at_);
            if (end != read_.npos) {
                const std::string result = read_.substr(at_, end - at_);
                at_ = end + 1;
                if (at_ > kKept) read_.erase(0, std::exchange(at_, 0));
                return result;
            }
            char bytes[65536];
            const ssize_t count = ::recv(socket_, bytes, sizeof bytes, 0);
            if (count < 0) return "(silence)";
            if (count == 0) return "(end)";
            read_.append(bytes, static_cast<std::size_t>(count));
        }
    }
    std::vector<std::string> lines(int count) {
        std::vector<std::string> result;
        for (int i = 0; i < count; ++i) result.push_back(line());
        return result;
    }
    /** Sends a command and returns the reply. */
    std::string ask(const std::string& command) { return send(command + "\n") ? line() : "(not sent)"; }
    /** Reads the greeting, and says VERSION. */
    bool greet() { return line() == "100 Orocos 1.0 TcpReporting Server 1.0" && ask("VERSION 1.0") == "101 OK"; }
    /** Everything up to the end of the connection. */
    std::string rest() {
        std::string result;
        for (std::string next = line(); next != "(end)" && next != "(silence)"; next = line()) result += next + "\n";
        result += read_.substr(at_);
        return result;
    }

private:
    static constexpr std::size_t kKept = 1 << 20;
    const int socket_;
    bool connected_ = false;
    std::string read_;
    std::size_t at_ = 0;
};

}  // namespace components_test

#endif
