// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "socket_folder.hpp"

#include "unix_address.hpp"

#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <dirent.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace OCL::live {
namespace {

constexpr mode_t kOnlyOwner = 0700;

/** The process in the name of a socket, "4711-Deployer.sock"; 0 if it has none. */
pid_t processOf(const char* name) {
    char* end = nullptr;
    if (!std::isdigit(static_cast<unsigned char>(*name))) return 0;
    errno = 0;
    const long number = std::strtol(name, &end, 10);
    const bool good = errno == 0 && *end == '-' && number > 0 && number <= INT32_MAX;
    const char* const dot = std::strrchr(name, '.');
    return good && dot && std::strcmp(dot, ".sock") == 0 ? static_cast<pid_t>(number) : 0;
}

/** A process of another container with the same folder has no number here, but takes connections. */
bool isRefused(const SocketFolder& folder, const std::string& name) {
    const Descriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const UnixAddress address(folder, name);
    return probe && address && ::connect(probe.get(), address.get(), address.size()) != 0 && errno == ECONNREFUSED;
}

}  // namespace

std::string SocketFolder::usual() {
    const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
    if (runtime && *runtime == '/') return std::string(runtime) + "/oroforge";
    return "/tmp/oroforge-" + std::to_string(::geteuid());
}

SocketFolder::SocketFolder(std::string path, Fault& fault) : path_(std::move(path)) {
    if (::mkdir(path_.c_str(), kOnlyOwner) != 0 && errno != EEXIST) {
        fault = {std::strerror(errno)};
        return;
    }
    Descriptor folder(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    struct stat found {};
    if (!folder && (errno == ENOTDIR || errno == ELOOP)) {
        fault = {"it is a symbolic link or a file, where a folder of this user is expected", true};
    } else if (!folder) {
        fault = {std::strerror(errno), errno == EACCES};
    } else if (::fstat(folder.get(), &found) != 0 || found.st_uid != ::geteuid()) {
        fault = {"it belongs to user " + std::to_string(found.st_uid) + ", where a folder of user " +
                     std::to_string(::geteuid()) + " is expected",
                 true};
    } else if ((found.st_mode & 07777U) != kOnlyOwner && ::fchmod(folder.get(), kOnlyOwner) != 0) {
        fault = {std::string("it cannot get the mode 0700: ") + std::strerror(errno), true};
    } else {
        folder_ = std::move(folder);
    }
}

void SocketFolder::removeStale() const {
    // Another description: reading moves its position.
    DIR* const entries = ::fdopendir(::openat(folder_.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!entries) return;
    while (const dirent* const entry = ::readdir(entries)) {
        const pid_t process = processOf(entry->d_name);
        if (process == 0) continue;
        // One with the number of this process may be left of another one that had it.
        const bool mayBeStale = process == ::getpid() || (::kill(process, 0) != 0 && errno == ESRCH);
        if (mayBeStale && isRefused(*this, entry->d_name)) (void)::unlinkat(folder_.get(), entry->d_name, 0);
    }
    (void)::closedir(entries);
}

}  // namespace OCL::live
