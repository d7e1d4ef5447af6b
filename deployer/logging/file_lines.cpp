// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "file_lines.hpp"

#include <rtt/Logger.hpp>
#include <rtt/os/own_file.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace OCL::logging {

FileLines::FileLines(const std::string& owner, std::string file) : FdLines(owner), name_(std::move(file)) {}

FileLines::~FileLines() { closeFile(); }

bool FileLines::open() {
    const std::string reason = tryToOpen();
    if (reason.empty()) return true;
    RTT::log(RTT::Error) << "appender '" << getName() << "' could not open file '" << name_ << "': " << reason
                         << RTT::endlog();
    return false;
}

void FileLines::closeFile() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
}

std::string FileLines::tryToOpen(bool empty) {
    closeFile();
    // Without O_NONBLOCK, opening a pipe would wait for a reader.
    file_ =
        RTT::os::detail::openOwnFile(name_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NONBLOCK | (empty ? O_TRUNC : 0));
    if (file_ < 0) return errno == ENXIO ? "no program reads from this pipe" : RTT::os::detail::openError(errno);
    struct stat status {};
    const bool known = ::fstat(file_, &status) == 0;
    if (known && S_ISREG(status.st_mode)) (void)::fcntl(file_, F_SETFL, O_APPEND);
    position_ = known && S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0;
    if (position_ > 0) endTornLine();
    return {};
}

void FileLines::endTornLine() {
    const int file = RTT::os::detail::openOwnFile(name_.c_str(), O_RDONLY | O_NONBLOCK);
    char last = '\n';
    const bool torn = file >= 0 && ::pread(file, &last, 1, static_cast<off_t>(position_ - 1)) == 1 && last != '\n';
    if (file >= 0) ::close(file);
    if (torn && ::write(file_, "\n", 1) == 1) ++position_;
}

bool FileLines::prepare(std::string& error) {
    struct stat status {};
    // A file that was removed is begun again: what is written to the old one would be lost.
    if (file_ >= 0 && (::fstat(file_, &status) != 0 || status.st_nlink != 0)) return true;
    error = tryToOpen();
    return error.empty();
}

void FileLines::keptOn(const std::string& reason) {
    if (keepsOn_) return;
    keepsOn_ = true;
    RTT::log(RTT::Error) << "appender '" << getName() << "' cannot begin file '" << name_
                         << "' anew, so it goes on with it: " << reason << RTT::endlog();
}

RollingFileLines::RollingFileLines(const std::string& owner, std::string file, std::uint64_t size, unsigned backups)
    : FileLines(owner, std::move(file)), size_(size), backups_(backups), rollAt_(size) {}

void RollingFileLines::write(const log4cpp::LoggingEvent& event, const std::string& record) {
    FdLines::write(event, record);
    if (end() < rollAt_) return;
    flush();
    if (position_ >= rollAt_) rollOver();
}

/** With as many digits for all files. */
std::string RollingFileLines::backup(unsigned index) const {
    const std::size_t width = std::to_string(backups_).size();
    const std::string number = std::to_string(index);
    return name_ + '.' + std::string(width - number.size(), '0') + number;
}

void RollingFileLines::rollOver() {
    bool moved = true;
    std::string reason;
    const auto move = [&](const std::string& from, const std::string& to) {
        if (std::rename(from.c_str(), to.c_str()) == 0 || errno == ENOENT) return true;
        reason = "'" + from + "' does not become '" + to + "': " + std::strerror(errno);
        return false;
    };
    for (unsigned i = backups_; moved && i > 1; --i) moved = move(backup(i - 1), backup(i));
    if (moved && backups_ > 0) moved = move(name_, backup(1));
    if (moved) {
        rollAt_ = size_;
        // If it fails, the next record tries again.
        if (tryToOpen(/*empty=*/backups_ == 0).empty()) return;
        position_ = 0;
        return;
    }
    rollAt_ = position_ + size_;
    keptOn(reason);
}

void GenerationalFileLines::advance() {
    flush();
    struct stat status {};
    unsigned generation = 1;
    std::string next;
    do next = name_ + '.' + std::to_string(generation++);
    while (::lstat(next.c_str(), &status) == 0);
    if (std::rename(name_.c_str(), next.c_str()) != 0 && errno != ENOENT)
        return keptOn("it does not become '" + next + "': " + std::strerror(errno));
    const std::string reason = tryToOpen();
    if (!reason.empty()) failed(0, reason);
}

}  // namespace OCL::logging
