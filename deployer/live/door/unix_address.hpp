// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_UNIX_ADDRESS_HPP
#define OROFORGE_LIVE_UNIX_ADDRESS_HPP

#include <string>

#include <sys/socket.h>
#include <sys/un.h>

namespace OCL::live {

class SocketFolder;

/** The address of a socket in a folder. Where the path is too long for it, it leads through the open folder, in
    /proc/self/fd. */
class UnixAddress {
public:
    UnixAddress(const SocketFolder& folder, const std::string& name);
    /** False if the name alone is too long. */
    explicit operator bool() const { return size_ != 0; }
    const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&bytes_); }
    socklen_t size() const { return size_; }

private:
    bool take(const std::string& path);

    sockaddr_un bytes_{};
    socklen_t size_ = 0;
};

/** "4711-Deployer.sock"; of a long name, only the first part, so that the whole has at most 64 bytes. */
std::string socketName(const std::string& deployment);

}  // namespace OCL::live

#endif
