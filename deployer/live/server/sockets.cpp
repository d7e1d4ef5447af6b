// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "sockets.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace OCL::live {
namespace {

/** A computer that has gone without a word is noticed after about that time, in seconds. */
constexpr int kKeepAlive = 60;

}  // namespace

std::string addressOf(int socket) {
    sockaddr_storage bytes{};
    socklen_t size = sizeof bytes;
    if (::getpeername(socket, reinterpret_cast<sockaddr*>(&bytes), &size) != 0) return "an unknown address";
    char text[INET6_ADDRSTRLEN] = "";
    const bool six = bytes.ss_family == AF_INET6;
    const auto* const in4 = reinterpret_cast<const sockaddr_in*>(&bytes);
    const auto* const in6 = reinterpret_cast<const sockaddr_in6*>(&bytes);
    const void* const address = six ? static_cast<const void*>(&in6->sin6_addr) : &in4->sin_addr;
    (void)::inet_ntop(bytes.ss_family, address, text, sizeof text);
    return (six ? "[" + std::string(text) + "]" : text) + ":" + std::to_string(ntohs(in4->sin_port));
}

int familyOf(int socket) {
    int family = AF_UNIX;
    socklen_t size = sizeof family;
    (void)::getsockopt(socket, SOL_SOCKET, SO_DOMAIN, &family, &size);
    return family;
}

void keepAlive(int socket) {
    const int on = 1, idle = kKeepAlive;
    (void)::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    (void)::setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
    (void)::setsockopt(socket, IPPROTO_TCP, TCP_KEEPIDLE, &idle, sizeof idle);
}

bool isExhaustion(int error) { return error == EMFILE || error == ENFILE || error == ENOBUFS || error == ENOMEM; }

}  // namespace OCL::live
