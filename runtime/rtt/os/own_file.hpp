// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_OWN_FILE_HPP
#define ORO_OS_OWN_FILE_HPP

#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace RTT {
namespace os {
namespace detail {

/**
 * open() with O_CLOEXEC and mode 0666 that follows only symbolic links of this user or root: with one planted in a
 * folder, another user could choose which file is overwritten. Such a link gives −1 and ELOOP.
 */
inline int openOwnFile(const char* name, int flags) noexcept {
    const int file = ::open(name, flags | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file >= 0 || errno != ELOOP) return file;
    struct stat link {};
    if (lstat(name, &link) != 0) return -1;
    if (S_ISLNK(link.st_mode) && link.st_uid != 0 && link.st_uid != geteuid()) {
        errno = ELOOP;
        return -1;
    }
    return ::open(name, flags | O_CLOEXEC, 0666);
}

/** Why openOwnFile() failed, by `errno`. */
inline std::string openError(int error) {
    return error == ELOOP ? "it is a symbolic link of another user" : std::strerror(error);
}

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
