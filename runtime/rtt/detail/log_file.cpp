// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_file.hpp>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace RTT {
namespace detail {

void writeAll(int descriptor, const char* text, std::size_t size) noexcept {
    while (size != 0) {
        const ssize_t written = ::write(descriptor, text, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return;
        text += written;
        size -= static_cast<std::size_t>(written);
    }
}

bool LogFile::open(const char* name, bool append) noexcept {
    // Programs that this process starts do not get it.
    descriptor_ = ::open(name, O_WRONLY | O_CREAT | O_CLOEXEC | (append ? O_APPEND : O_TRUNC), 0666);
    used_ = 0;
    return isOpen();
}

void LogFile::write(const char* text, std::size_t size) noexcept {
    if (!isOpen()) return;
    if (size > sizeof buffer_ - used_) flush();
    if (size > sizeof buffer_) return writeAll(descriptor_, text, size);
    std::memcpy(buffer_ + used_, text, size);
    used_ += size;
}

void LogFile::flush() noexcept {
    if (isOpen()) writeAll(descriptor_, buffer_, used_);
    used_ = 0;
}

void LogFile::close() noexcept {
    flush();
    if (isOpen()) ::close(descriptor_);
    descriptor_ = -1;
}

}  // namespace detail
}  // namespace RTT
