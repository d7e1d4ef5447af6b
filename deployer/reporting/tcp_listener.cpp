// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "tcp_listener.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <netinet/in.h>
#include <sys/socket.h>
#include <system_error>

namespace OCL::reporting {
namespace {

constexpr unsigned int kLastPort = 65535;
/** How many ports are tried if the first one is in use. */
constexpr unsigned int kFurtherPorts = 4;

std::string systemError(int number) { return std::generic_category().message(number); }

/** An address of either family. */
struct Address {
    sockaddr_storage bytes{};
    socklen_t size = 0;  // 0: not an address

    const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&bytes); }
    sockaddr* get() { return reinterpret_cast<sockaddr*>(&bytes); }
    // The port has the same place in both.
    void setPort(unsigned int port) {
        const std::uint16_t value = htons(static_cast<std::uint16_t>(port));
        std::memcpy(reinterpret_cast<char*>(&bytes) + offsetof(sockaddr_in, sin_port), &value, sizeof value);
    }
    unsigned int port() const {
        std::uint16_t value = 0;
        std::memcpy(&value, reinterpret_cast<const char*>(&bytes) + offsetof(sockaddr_in, sin_port), sizeof value);
        return ntohs(value);
    }
};
static_assert(offsetof(sockaddr_in, sin_port) == offsetof(sockaddr_in6, sin6_port), "one place for the port");

Address addressOf(std::string text) {
    if (text == "localhost") text = "127.0.0.1";
    Address result;
    sockaddr_in four{};
    sockaddr_in6 six{};
    if (::inet_pton(AF_INET, text.c_str(), &four.sin_addr) == 1) {
        four.sin_family = AF_INET;
        std::memcpy(&result.bytes, &four, result.size = sizeof four);
    } else if (::inet_pton(AF_INET6, text.c_str(), &six.sin6_addr) == 1) {
        six.sin6_family = AF_INET6;
        std::memcpy(&result.bytes, &six, result.size = sizeof six);
    }
    return result;
}

/** 0, or the number of the error. */
int tryPort(Descriptor& socket, const Address& address) {
    socket.reset(::socket(address.get()->sa_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!socket) return errno;
    // Else a port cannot be used for a minute after clients were disconnected.
    const int on = 1;
    (void)::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (::bind(socket.get(), address.get(), address.size) == 0 && ::listen(socket.get(), SOMAXCONN) == 0) return 0;
    return errno;
}

}  // namespace

TcpListener listenOn(const std::string& address, unsigned int port, std::string& error) {
    TcpListener result;
    Address place = addressOf(address);
    if (place.size == 0) {
        error = "'" + address + "' is not an address; write one such as 127.0.0.1, or 0.0.0.0 for all of this computer";
        return result;
    }
    if (port > kLastPort) {
        error = std::to_string(port) + " is not a port; write 0 to " + std::to_string(kLastPort);
        return result;
    }
    const unsigned int last = port == 0 ? 0 : std::min(port + kFurtherPorts, kLastPort);
    int failure = 0;
    for (unsigned int next = port; next <= last; ++next) {
        place.setPort(next);
        failure = tryPort(result.socket, place);
        if (failure != EADDRINUSE) break;
    }
    if (failure == 0) {
        (void)::getsockname(result.socket.get(), place.get(), &place.size);
        result.port = place.port();
        return result;
    }
    result.socket.reset();
    const std::string where = "port " + std::to_string(port) + " of " + address;
    if (failure == EADDRINUSE)
        error = where + " and those up to " + std::to_string(last) +
                " are in use; set the property 'port' to another one, or to 0 for any that is free";
    else
        error = where + ": " + systemError(failure);
    return result;
}

bool isLoopback(const std::string& address) {
    const Address place = addressOf(address);
    if (place.get()->sa_family == AF_INET6) {
        sockaddr_in6 six{};
        std::memcpy(&six, &place.bytes, sizeof six);
        return IN6_IS_ADDR_LOOPBACK(&six.sin6_addr);
    }
    sockaddr_in four{};
    std::memcpy(&four, &place.bytes, sizeof four);
    return ntohl(four.sin_addr.s_addr) >> 24U == 127;
}

}  // namespace OCL::reporting
