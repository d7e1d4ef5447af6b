// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Several processes may do this at once. The one that holds the lock of a file, and then still finds the file under its
// name, alone may rename it. There is no moment at which the name leads to a file that nobody has locked.
#include <rtt/detail/log_claim.hpp>

#include <rtt/os/own_file.hpp>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace RTT::detail {

namespace {

constexpr int kAdding = O_WRONLY | O_CREAT | O_APPEND;
constexpr int kTries = 1000, kNames = 10;

enum class Claim { Taken, Held, Failed };

std::string realPath(const std::string& name) {
    char path[PATH_MAX];
    return realpath(name.c_str(), path) ? path : name;
}

/** A FIFO with a name, unlike a pipe that /dev/stderr leads to. */
bool isFifo(const std::string& name) {
    struct stat status {};
    return lstat(realPath(name).c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

/** As a reader of its own FIFO, the process neither waits for another one nor gets SIGPIPE when that ends. */
int openForAdding(const std::string& name) {
    if (isFifo(name)) return os::detail::openOwnFile(name.c_str(), O_RDWR | O_NONBLOCK);
    return os::detail::openOwnFile(name.c_str(), kAdding);
}

/** On file systems without locks, processes do not know of each other. */
bool lock(int file) { return flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

bool sameFile(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

/** The standard output goes there as well, as with ORO_LOGFILE=/dev/stderr: it would follow the renamed file. */
bool isOutput(const struct stat& file) {
    struct stat status {};
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        if (fstat(output, &status) == 0 && sameFile(status, file)) return true;
    return false;
}

std::string numbered(const std::string& path, unsigned number) { return path + '.' + std::to_string(number); }

/** Frees `path`.1, by the loss of `path`.<keep> if there are so many. */
void shift(const std::string& path, unsigned keep) {
    struct stat status {};
    unsigned gap = 1;
    while (gap < keep && lstat(numbered(path, gap).c_str(), &status) == 0) ++gap;
    for (; gap > 1; --gap) (void)std::rename(numbered(path, gap - 1).c_str(), numbered(path, gap).c_str());
    if (keep == 1) (void)unlink(numbered(path, 1).c_str());
}

/** An empty file like `model`, locked, under a name that only this process uses. */
int makeEmpty(const std::string& name, const struct stat& model) {
    const int flags = kAdding | O_EXCL | O_CLOEXEC | O_NOFOLLOW;
    int file = ::open(name.c_str(), flags, 0666);
    // A process with the same id may have died before it renamed it.
    if (file < 0 && errno == EEXIST && unlink(name.c_str()) == 0) file = ::open(name.c_str(), flags, 0666);
    if (file < 0) return -1;
    (void)lock(file);
    (void)fchmod(file, model.st_mode & 0777U);
    if (geteuid() == 0 && fchown(file, model.st_uid, model.st_gid) != 0) errno = 0;  // a file system without owners
    return file;
}

/** For file systems without hard links: another process may make the file in between. */
int rotateByName(const std::string& path, const struct stat& old) {
    if (std::rename(path.c_str(), numbered(path, 1).c_str()) != 0) return -1;
    const int file = ::open(path.c_str(), kAdding | O_EXCL | O_CLOEXEC | O_NOFOLLOW, old.st_mode & 0777U);
    struct stat status {};
    // A process that locked it first may even have ended since.
    if (file < 0 || !lock(file) || fstat(file, &status) != 0 || status.st_size != 0 || !leadsTo(path, status)) {
        if (file >= 0) ::close(file);
        errno = EAGAIN;
        return -1;
    }
    return file;
}

Claim fail(ClaimedLog& log, int error) {
    log.error = error;
    return Claim::Failed;
}

Claim take(ClaimedLog& log, int file) {
    log.descriptor = file;
    log.error = 0;
    return Claim::Taken;
}

/** Takes the file that this process has locked, which is at its name. Held: another process has it after all. */
Claim takeLocked(ClaimedLog& log, int file, const struct stat& status, unsigned keep, const struct stat* again) {
    log.path = realPath(log.name);
    if (status.st_size == 0 || (again && sameFile(*again, status))) return take(log, file);
    if (keep == 0) {
        if (ftruncate(file, 0) != 0) log.rotateError = errno;
        return take(log, file);
    }
    const int fresh = rotateLog(log.path, file, keep);
    if (fresh < 0 && errno == EAGAIN) return Claim::Held;
    log.rotated = fresh >= 0;
    if (fresh < 0) log.rotateError = errno;
    if (fresh < 0) return take(log, file);
    ::close(file);
    return take(log, fresh);
}

Claim claim(ClaimedLog& log, unsigned keep, const struct stat* again) {
    for (int tries = 0; tries != kTries; ++tries) {
        const int file = openForAdding(log.name);
        if (file < 0) return fail(log, errno);
        struct stat status {};
        if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || isOutput(status)) return take(log, file);
        const bool locked = lock(file);
        // Another process may have renamed the file since this one opened it.
        if (!leadsTo(log.name, status)) {
            ::close(file);
            continue;
        }
        if (!locked) {
            ::close(file);
            return Claim::Held;
        }
        (void)fstat(file, &status);  // the process that had it before has written since
        const Claim result = takeLocked(log, file, status, keep, again);
        if (result != Claim::Held) return result;
        ::close(file);
    }
    return Claim::Held;
}

/** "orocos-123.log"; "orocos-123-2.log" if that is taken, too, as between containers that share a folder. */
std::string ownName(const std::string& name, int number) {
    const std::size_t folder = name.rfind('/') + 1;  // 0 without a folder
    const std::size_t point = name.rfind('.');
    const std::size_t end = point == std::string::npos || point <= folder ? name.size() : point;
    return name.substr(0, end) + '-' + std::to_string(getpid()) + (number > 1 ? '-' + std::to_string(number) : "") +
           name.substr(end);
}

bool isFileOfAnotherUser(const std::string& name) {
    struct stat status {};
    return stat(name.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid != geteuid();
}

}  // namespace

bool leadsTo(const std::string& name, const struct stat& file) {
    struct stat status {};
    return stat(name.c_str(), &status) == 0 && sameFile(status, file);
}

int rotateLog(const std::string& path, int descriptor, unsigned keep) {
    struct stat old {
    }, first{};
    if (fstat(descriptor, &old) != 0) return -1;
    const std::string last = numbered(path, 1), fresh = path + '.' + std::to_string(getpid()) + ".new";
    const int file = makeEmpty(fresh, old);
    if (file < 0) return -1;
    // A process may have died between the two steps below.
    const bool linked = lstat(last.c_str(), &first) == 0 && sameFile(first, old);
    if (!linked) shift(path, keep);
    if (linked || link(path.c_str(), last.c_str()) == 0) {
        if (std::rename(fresh.c_str(), path.c_str()) == 0) return file;
    } else if (errno != EEXIST) {
        (void)unlink(fresh.c_str());
        ::close(file);
        return rotateByName(path, old);
    }
    const int error = errno;
    (void)unlink(fresh.c_str());
    ::close(file);
    errno = error;
    return -1;
}

ClaimedLog claimLog(const std::string& name, unsigned keep, const struct stat* again) {
    ClaimedLog log;
    log.name = name;
    const Claim first = claim(log, keep, again);
    if (first == Claim::Taken) return log;
    const bool foreign = first == Claim::Failed && log.error == EACCES && isFileOfAnotherUser(name);
    if (first == Claim::Failed && !foreign) return log;
    for (int number = 1; number <= kNames; ++number) {
        ClaimedLog own;
        own.name = ownName(name, number);
        own.heldBy = foreign ? "another user" : "another process";
        const Claim second = claim(own, keep, nullptr);
        if (second != Claim::Held) return own;
    }
    log.error = EBUSY;
    return log;
}

}  // namespace RTT::detail
