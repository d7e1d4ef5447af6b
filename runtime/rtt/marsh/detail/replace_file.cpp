// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "replace_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace RTT {
namespace marsh {

namespace fs = std::filesystem;

namespace {

std::error_code lastError() { return {errno, std::generic_category()}; }

/** What a symbolic link leads to, whether or not that exists. */
fs::path followed(fs::path path) {
    std::error_code failed;
    for (int links = 0; links != 40 && fs::is_symlink(path, failed); ++links) {
        const fs::path next = fs::read_symlink(path, failed);
        if (failed) break;
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return path;
}

/** Writes everything and closes. */
std::error_code writeAll(int descriptor, const std::string& text) {
    std::error_code failed;
    for (std::size_t done = 0; done != text.size() && !failed;) {
        const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
        if (count >= 0)
            done += static_cast<std::size_t>(count);
        else if (errno != EINTR)
            failed = lastError();
    }
    if (::close(descriptor) != 0 && !failed) failed = lastError();
    return failed;
}

/** The file must exist: for a new one the system may refuse what it allows for an old one, in a sticky folder. */
std::error_code overwrite(const std::string& file, const std::string& text) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    return descriptor < 0 ? lastError() : writeAll(descriptor, text);
}

/** Opens a new file beside `target` and sets its name. */
int openBeside(const std::string& target, std::string& name) {
    static std::atomic<unsigned> count{0};
    for (int attempts = 0; attempts != 100; ++attempts) {
        name = target + '.' + std::to_string(::getpid()) + '.' + std::to_string(count++) + ".new";
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) return descriptor;
    }
    return -1;
}

/** Owner, group and permissions of `before`, as far as this process may set them. */
std::error_code takeOver(int descriptor, const struct stat& before) {
    mode_t kept = 07777;
    if (::fchown(descriptor, before.st_uid, before.st_gid) != 0)
        kept = ::fchown(descriptor, static_cast<uid_t>(-1), before.st_gid) == 0 ? 02777 : 0777;
    // Last, because a change of owner clears some.
    return ::fchmod(descriptor, before.st_mode & kept) == 0 ? std::error_code() : lastError();
}

/** True if a file that may be written to can give that when another is put beside it or in its place. */
bool mayOverwriteAfter(const std::error_code& failed) {
    switch (failed.value()) {
        case EACCES:
        case EPERM:
        case EROFS:
        case EBUSY:
        case EXDEV: return true;
        default: return false;
    }
}

/** `before` is null if there is no such file yet. */
std::error_code replaceBy(const std::string& target, const std::string& text, const struct stat* before) {
    std::string beside;
    const int descriptor = openBeside(target, beside);
    if (descriptor < 0) return lastError();
    std::error_code failed = before ? takeOver(descriptor, *before) : std::error_code();
    const std::error_code written = writeAll(descriptor, text);
    if (!failed) failed = written;
    if (!failed && std::rename(beside.c_str(), target.c_str()) != 0) failed = lastError();
    if (failed) ::unlink(beside.c_str());
    return failed;
}

}  // namespace

std::error_code replaceFile(const std::string& file, const std::string& text) {
    const std::string target = followed(file).string();
    struct stat before {};
    const bool exists = ::stat(target.c_str(), &before) == 0;
    if (!exists && errno != ENOENT) return lastError();
    if (exists && !S_ISREG(before.st_mode)) return overwrite(target, text);
    if (exists && ::access(target.c_str(), W_OK) != 0) return lastError();

    const std::error_code failed = replaceBy(target, text, exists ? &before : nullptr);
    return exists && mayOverwriteAfter(failed) ? overwrite(target, text) : failed;
}

}  // namespace marsh
}  // namespace RTT
