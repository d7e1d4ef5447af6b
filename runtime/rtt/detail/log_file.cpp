// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_file.hpp>

#include <rtt/os/own_file.hpp>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace RTT::detail {

namespace {

constexpr int kTries = 20;
constexpr timespec kPause{0, 1000000};

bool isRegular(int file) {
    struct stat status {};
    return fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

/** Held until the file is closed. Processes that add to it share the lock; one that empties it needs it alone. */
void lockForAdding(int file) {
    for (int times = 0; times != kTries && flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK; ++times)
        nanosleep(&kPause, nullptr);
}

}  // namespace

bool writeAll(int descriptor, const char* text, std::size_t size) noexcept {
    while (size != 0) {
        const ssize_t written = ::write(descriptor, text, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        text += written;
        size -= static_cast<std::size_t>(written);
    }
    return true;
}

bool LogFile::open(const char* name, bool append) noexcept {
    // Programs that this process starts do not inherit the file. Lines of several processes do not mix.
    descriptor_ = os::detail::openOwnFile(name, O_WRONLY | O_CREAT | O_APPEND);
    used_ = 0;
    failure_ = 0;
    failureTaken_ = shared_ = false;
    if (!isOpen() || !isRegular(descriptor_)) return isOpen();
    // On file systems without locks, processes do not know of each other.
    const bool alone = flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    shared_ = !alone && errno == EWOULDBLOCK;
    if (!append && !shared_ && ftruncate(descriptor_, 0) != 0) failure_ = errno;
    lockForAdding(descriptor_);
    return true;
}

void LogFile::put(const char* text, std::size_t size) noexcept {
    if (!writeAll(descriptor_, text, size) && failure_ == 0) failure_ = errno != 0 ? errno : EIO;
}

int LogFile::takeFailure() noexcept {
    if (failure_ == 0 || failureTaken_) return 0;
    failureTaken_ = true;
    return failure_;
}

void LogFile::write(const char* text, std::size_t size) noexcept {
    if (!isOpen()) return;
    if (size > sizeof buffer_ - used_) flush();
    if (size > sizeof buffer_) return put(text, size);
    std::memcpy(buffer_ + used_, text, size);
    used_ += size;
}

void LogFile::flush() noexcept {
    if (isOpen() && used_ != 0) put(buffer_, used_);
    used_ = 0;
}

void LogFile::close() noexcept {
    flush();
    if (isOpen()) ::close(descriptor_);
    descriptor_ = -1;
}

}  // namespace RTT::detail
