// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "unix_address.hpp"

#include "socket_folder.hpp"

#include <cstddef>
#include <cstring>

#include <unistd.h>

namespace OCL::live {
namespace {

constexpr std::size_t kLongestName = 64;

bool isMiddleOfCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

UnixAddress::UnixAddress(const SocketFolder& folder, const std::string& name) {
    if (!take(folder.path() + "/" + name)) (void)take("/proc/self/fd/" + std::to_string(folder.get()) + "/" + name);
}

bool UnixAddress::take(const std::string& path) {
    if (path.size() >= sizeof bytes_.sun_path) return false;
    bytes_.sun_family = AF_UNIX;
    std::memcpy(bytes_.sun_path, path.c_str(), path.size() + 1);
    size_ = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size() + 1);
    return true;
}

std::string socketName(const std::string& deployment) {
    const std::string process = std::to_string(::getpid()) + "-", end = ".sock";
    std::size_t size = kLongestName - process.size() - end.size();
    if (deployment.size() <= size) return process + deployment + end;
    while (size != 0 && isMiddleOfCharacter(deployment[size])) --size;
    return process + deployment.substr(0, size) + end;
}

}  // namespace OCL::live
