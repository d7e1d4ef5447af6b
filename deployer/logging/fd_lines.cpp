// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "fd_lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iostream>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace OCL::logging {
namespace {

constexpr std::uint64_t kPage = 4096;
constexpr int kPatience = 1000;  // milliseconds that a full pipe or terminal is waited for

}  // namespace

void FdLines::write(const log4cpp::LoggingEvent&, const std::string& record) {
    const bool crosses = end() / kPage != (end() + record.size() - 1) / kPage;
    if (crosses) flush();
    text_ += record;
    ends_.push_back(text_.size());
    if (crosses) flush();
}

std::size_t FdLines::writeAll(std::string& error) const {
    std::size_t written = 0;
    while (written != text_.size()) {
        const ssize_t done = ::write(file_, text_.data() + written, text_.size() - written);
        if (done >= 0) {
            written += static_cast<std::size_t>(done);
            continue;
        }
        if (errno == EINTR) continue;
        pollfd wait{file_, POLLOUT, 0};
        if (errno == EAGAIN && ::poll(&wait, 1, kPatience) > 0) continue;
        error = std::strerror(errno);
        break;
    }
    return written;
}

/** Removes the beginning of a record from the end of a file; a pipe has passed it on. */
void FdLines::takeBack(std::size_t bytes) const {
    struct stat status {};
    const off_t here = ::lseek(file_, 0, SEEK_CUR);
    // What other writers have added meanwhile stays.
    if (bytes == 0 || here < 0 || ::fstat(file_, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size != here)
        return;
    if (::ftruncate(file_, here - static_cast<off_t>(bytes)) == 0)
        (void)::lseek(file_, here - static_cast<off_t>(bytes), SEEK_SET);
}

void FdLines::flush() {
    if (text_.empty()) return;
    std::string error;
    std::size_t written = 0;
    if (prepare(error)) written = writeAll(error);
    const auto torn = std::upper_bound(ends_.begin(), ends_.end(), written);
    const std::size_t whole = torn == ends_.begin() ? 0 : *(torn - 1);
    if (written != whole) takeBack(written - whole);
    position_ += whole;
    const auto lost = static_cast<std::size_t>(ends_.end() - torn);
    text_.clear();
    ends_.clear();
    if (lost == 0)
        succeeded();
    else
        failed(lost, error);
}

OutputLines::OutputLines(const std::string& owner) : FdLines(owner) { file_ = STDOUT_FILENO; }

bool OutputLines::prepare(std::string&) {
    std::cout.flush();  // other code writes there, too
    return true;
}

}  // namespace OCL::logging
