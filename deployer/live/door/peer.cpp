// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "peer.hpp"

#include <sys/socket.h>
#include <unistd.h>

namespace OCL::live {

bool Peer::mayEnter() const { return known && (user == ::geteuid() || user == 0); }

std::string Peer::text() const { return "process " + std::to_string(process) + " of user " + std::to_string(user); }

Peer peerOf(int socket) {
    ucred found{};
    socklen_t size = sizeof found;
    if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &found, &size) != 0 || size != sizeof found) return {};
    return {true, found.uid, found.pid};
}

}  // namespace OCL::live
