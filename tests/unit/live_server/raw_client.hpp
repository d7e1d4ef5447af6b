// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A client that writes its own bytes, so that it can write wrong ones.
#ifndef OROFORGE_TEST_LIVE_RAW_CLIENT_HPP
#define OROFORGE_TEST_LIVE_RAW_CLIENT_HPP

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace live_test {

class RawClient {
public:
    static RawClient unixSocket(const std::string& path) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
        return RawClient(AF_UNIX, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    }
    static RawClient tcp(unsigned port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return RawClient(AF_INET, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    }
    RawClient(RawClient&& other) noexcept : socket_(other.socket_), rest_(std::move(other.rest_)) {
        other.socket_ = -1;
    }
    ~RawClient() {
        if (socket_ >= 0) ::close(socket_);
    }
    bool connected() const { return socket_ >= 0; }
    int socket() const { return socket_; }

    bool send(const std::string& bytes) const {
        for (std::size_t done = 0; done != bytes.size();) {
            const ssize_t size = ::send(socket_, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
            if (size <= 0) return false;
            done += static_cast<std::size_t>(size);
        }
        return true;
    }
    /** Everything up to the end of an HTTP header; less at the end of the connection or after five seconds. */
    std::string head() {
        while (rest_.find("\r\n\r\n") == std::string::npos && more()) {
        }
        const std::size_t end = rest_.find("\r\n\r\n");
        const std::string result = rest_.substr(0, end);
        rest_.erase(0, end == std::string::npos ? end : end + 4);
        return result;
    }
    /** Everything up to the end of the connection, or that came within the time. */
    std::string all(int milliseconds = 5000) {
        while (more(milliseconds)) {
        }
        return std::exchange(rest_, std::string());
    }
    /** True as soon as the other side has closed. */
    bool closes(int milliseconds = 5000) {
        while (more(milliseconds)) {
        }
        return closed_;
    }
    /** Opens a WebSocket; false if that is refused. */
    bool open(const std::string& protocol = "oro.v1", const std::string& target = "/") {
        return send("GET " + target + " HTTP/1.1\r\nHost: localhost\r\n" + upgrade(protocol) + "\r\n") &&
               head().compare(0, 12, "HTTP/1.1 101") == 0;
    }
    static std::string upgrade(const std::string& protocol) {
        return "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: " +
               protocol + "\r\n";
    }
    /** A frame of a client. */
    static std::string frame(const std::string& payload, unsigned char head = 0x81, std::uint64_t length = UINT64_MAX,
                             bool masked = true) {
        if (length == UINT64_MAX) length = payload.size();
        std::string bytes(1, static_cast<char>(head));
        const auto mask = static_cast<unsigned char>(masked ? 0x80 : 0);
        const int digits = length < 126 ? 0 : length <= 0xFFFF ? 2 : 8;
        bytes += static_cast<char>(mask | (digits == 0 ? length : digits == 2 ? 126U : 127U));
        for (int i = digits - 1; i >= 0; --i) bytes += static_cast<char>(length >> (8 * i));
        if (masked) bytes += std::string(4, '\0');  // a mask that changes nothing
        return bytes + payload;
    }
    bool say(const nlohmann::json& message) const { return send(frame(message.dump())); }
    /** The next message; null at the end of the connection or after five seconds. Binary ones are texts. */
    nlohmann::json hear() {
        std::string payload;
        const int kind = message(payload);
        if (kind == 1) return nlohmann::json::parse(payload, nullptr, false);
        return kind == 2 ? nlohmann::json(payload) : nlohmann::json();
    }
    /** The next message with this op. */
    nlohmann::json hear(const std::string& op) {
        for (;;) {
            nlohmann::json message = hear();
            if (message.is_null() || (message.is_object() && message.value("op", "") == op)) return message;
        }
    }

private:
    RawClient(int family, const sockaddr* address, socklen_t size)
        : socket_(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        if (::connect(socket_, address, size) == 0) return;
        ::close(socket_);
        socket_ = -1;
    }
    bool more(int milliseconds = 5000) {
        char bytes[65536];
        pollfd polled{socket_, POLLIN, 0};
        if (socket_ < 0 || ::poll(&polled, 1, milliseconds) != 1) return false;
        const ssize_t size = ::recv(socket_, bytes, sizeof bytes, 0);
        if (size > 0) rest_.append(bytes, static_cast<std::size_t>(size));
        if (size <= 0) closed_ = true;
        return size > 0;
    }
    bool need(std::size_t size) {
        while (rest_.size() < size)
            if (!more()) return false;
        return true;
    }
    int message(std::string& payload) {
        if (!need(2)) return -1;
        const int kind = rest_[0] & 15;
        std::uint64_t length = rest_[1] & 127;
        const std::size_t digits = length < 126 ? 0 : length == 126 ? 2 : 8;
        if (!need(2 + digits)) return -1;
        if (digits != 0) length = 0;
        for (std::size_t i = 0; i != digits; ++i) length = length << 8U | static_cast<unsigned char>(rest_[2 + i]);
        if (!need(2 + digits + length)) return -1;
        payload = rest_.substr(2 + digits, length);
        rest_.erase(0, 2 + digits + length);
        return kind;
    }

    int socket_;
    std::string rest_;
    bool closed_ = false;
};

}  // namespace live_test

#endif
