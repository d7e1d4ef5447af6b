// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_PEER_HPP
#define OROFORGE_LIVE_PEER_HPP

#include <string>

#include <sys/types.h>

namespace OCL::live {

/** The process at the other end of a Unix socket when it connected, as the kernel says. */
struct Peer {
    bool known = false;
    uid_t user = 0;
    pid_t process = 0;

    /** Only this user, and root, may use the socket. */
    bool mayEnter() const;
    /** "process 4711 of user 1000" */
    std::string text() const;
};

Peer peerOf(int socket);

}  // namespace OCL::live

#endif
