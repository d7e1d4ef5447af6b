// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_FILE_HPP
#define RTT_DETAIL_LOG_FILE_HPP

#include <cstddef>

namespace RTT {
namespace detail {

/** Writes the whole text to a file descriptor; false on an error. May be called by a signal handler. */
bool writeAll(int descriptor, const char* text, std::size_t size) noexcept;

/** The log file. Not a FILE, because a signal handler has to flush it, too. */
class LogFile {
public:
    /** Empties the file, except with `append` or if another process writes to it, too. False if it cannot be opened. */
    bool open(const char* name, bool append) noexcept;
    /** True if another process had the file open. */
    bool isShared() const noexcept { return shared_; }
    bool isOpen() const noexcept { return descriptor_ >= 0; }
    void write(const char* text, std::size_t size) noexcept;
    void flush() noexcept;
    void close() noexcept;
    /** The error number of the first write that failed, once; otherwise 0. */
    int takeFailure() noexcept;

private:
    void put(const char* text, std::size_t size) noexcept;

    int descriptor_ = -1;
    bool shared_ = false;
    int failure_ = 0;
    bool failureTaken_ = false;
    std::size_t used_ = 0;
    char buffer_[4096];
};

}  // namespace detail
}  // namespace RTT
#endif
