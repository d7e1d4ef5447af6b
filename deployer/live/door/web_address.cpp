// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "web_address.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <sys/socket.h>

namespace OCL::live {
namespace {

constexpr unsigned kLastPort = 65535;

/** An address of either family; size 0 if the text is none. */
struct Address {
    explicit Address(const WebAddress& from) {
        auto* const four = reinterpret_cast<sockaddr_in*>(&bytes);
        auto* const six = reinterpret_cast<sockaddr_in6*>(&bytes);
        if (::inet_pton(AF_INET, from.host.c_str(), &four->sin_addr) == 1) {
            four->sin_family = AF_INET;
            four->sin_port = htons(static_cast<std::uint16_t>(from.port));
            size = sizeof *four;
        } else if (::inet_pton(AF_INET6, from.host.c_str(), &six->sin6_addr) == 1) {
            six->sin6_family = AF_INET6;
            six->sin6_port = htons(static_cast<std::uint16_t>(from.port));
            size = sizeof *six;
        }
    }
    sockaddr* get() { return reinterpret_cast<sockaddr*>(&bytes); }
    bool isLoopback() const {
        if (bytes.ss_family == AF_INET6)
            return IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6*>(&bytes)->sin6_addr);
        return ntohl(reinterpret_cast<const sockaddr_in*>(&bytes)->sin_addr.s_addr) >> 24U == 127;
    }
    /** The port has the same place in both. */
    unsigned port() const { return ntohs(reinterpret_cast<const sockaddr_in*>(&bytes)->sin_port); }

    sockaddr_storage bytes{};
    socklen_t size = 0;
};

bool parsePort(const std::string& text, unsigned& port) {
    if (text.empty() || text.size() > 5 || text.find_first_not_of("0123456789") != std::string::npos) return false;
    port = static_cast<unsigned>(std::stoul(text));
    return port <= kLastPort;
}

}  // namespace

bool WebAddress::isLoopback() const {
    const Address address(*this);
    return address.size != 0 && address.isLoopback();
}

std::string WebAddress::text() const {
    const bool six = host.find(':') != std::string::npos;
    return (six ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

bool parseWebAddress(const std::string& text, WebAddress& result, std::string& error) {
    result = {};
    const bool bracket = !text.empty() && text[0] == '[';
    const std::size_t close = bracket ? text.find(']') : std::string::npos;
    const std::size_t colon = bracket ? (close == std::string::npos ? close : text.find(':', close)) : text.rfind(':');
    std::string host = text.substr(0, colon), port = colon == std::string::npos ? "" : text.substr(colon + 1);
    const bool onlyPort = colon == std::string::npos && parsePort(text, result.port);
    if (onlyPort) host.clear();
    if (bracket && close != std::string::npos) host = text.substr(1, close - 1);
    if (bracket && (close == std::string::npos || (close + 1 != text.size() && colon != close + 1))) host = text;
    if (host == "localhost") host = "127.0.0.1";
    if (!host.empty()) result.host = host;
    if (colon != std::string::npos && !parsePort(port, result.port)) {
        error = "'" + port + "' is not a port; write 0 to " + std::to_string(kLastPort);
    } else if (Address(result).size == 0) {
        error = "'" + text + "' is not an address; write ADDRESS:PORT, such as 127.0.0.1:8765 or [::1]:8765";
    } else {
        return true;
    }
    return false;
}

Descriptor listenAt(WebAddress& address, std::string& error) {
    Address place(address);
    Descriptor socket(::socket(place.get()->sa_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const int on = 1;
    // Else a port cannot be used for a minute after clients were disconnected.
    if (socket) (void)::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (socket && ::bind(socket.get(), place.get(), place.size) == 0 && ::listen(socket.get(), SOMAXCONN) == 0) {
        (void)::getsockname(socket.get(), place.get(), &place.size);
        address.port = place.port();
        return socket;
    }
    error = std::strerror(errno);
    return Descriptor();
}

}  // namespace OCL::live
