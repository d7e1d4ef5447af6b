// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_FILE_HPP
#define RTT_DETAIL_LOG_FILE_HPP

#include <rtt/detail/log_settings.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

#include <sys/stat.h>

namespace RTT {
namespace detail {

/** Writes the whole text to a file descriptor; false on an error. May be called by a signal handler. */
bool writeAll(int descriptor, const char* text, std::size_t size) noexcept;

/** The log file. Not a FILE, because a signal handler has to flush it, too. */
class LogFile {
public:
    /** See claimLog(). A file that this object had open before is added to. False if none can be opened. Adds to
        `notes` what readers of the log must know. */
    bool open(const LogFileRules& rules, LogNotes& notes);
    bool isOpen() const noexcept { return descriptor_ >= 0; }
    /** Of a regular file that is open; otherwise empty. */
    std::string path() const { return isOpen() ? path_ : std::string(); }
    /** Writes a line, to a new file if the present one would get too large. */
    void write(const char* text, std::size_t size);
    /** Writes a part of a line. May be called by a signal handler. */
    void add(const char* text, std::size_t size) noexcept;
    void flush() noexcept;
    void close() noexcept;
    /** A child of fork() leaves the file to its parent, but writes to it, too. */
    void leaveToParent() noexcept { owned_ = false; }
    /** What the first write that failed, or the first change of the file, was hindered by, once; otherwise empty. */
    std::string takeFailure();

private:
    void put(const char* text, std::size_t size) noexcept;
    void rotate();
    int replace();
    void removeLeftovers(LogNotes& notes) const;

    int descriptor_ = -1;
    LogFileRules rules_;
    std::string name_, path_;  // as in ClaimedLog
    struct stat identity_ {};
    bool owned_ = false;  // this process may rotate it
    std::uint64_t size_ = 0, limit_ = 0;
    int failure_ = 0, rotateFailure_ = 0;
    bool failureTaken_ = false, rotateFailureTaken_ = false;
    std::size_t used_ = 0;
    char buffer_[4096];
};

}  // namespace detail
}  // namespace RTT
#endif
