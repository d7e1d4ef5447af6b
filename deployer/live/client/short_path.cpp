// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "short_path.hpp"

#include <fcntl.h>
#include <sys/un.h>
#include <unistd.h>

namespace oroforge::live_client {

ShortPath::ShortPath(const std::string& path) : text_(path) {
    const std::size_t slash = path.rfind('/');
    if (path.size() < sizeof(sockaddr_un::sun_path) || slash == std::string::npos || slash == 0) return;
    folder_ = open(path.substr(0, slash).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (folder_ >= 0) text_ = "/proc/self/fd/" + std::to_string(folder_) + path.substr(slash);
}

ShortPath::~ShortPath() {
    if (folder_ >= 0) close(folder_);
}

}  // namespace oroforge::live_client
