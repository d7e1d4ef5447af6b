// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_FILE_HPP
#define RTT_DETAIL_LOG_FILE_HPP

#include <cstddef>

namespace RTT {
namespace detail {

/** Writes all of it to a file descriptor; gives up at an error. May be called by a signal handler. */
void writeAll(int descriptor, const char* text, std::size_t size) noexcept;

/** The log file. Not a FILE: what is not flushed yet must be written by a signal handler, too. */
class LogFile {
public:
    /** Empties the file, or continues it. False if it cannot be opened. */
    bool open(const char* name, bool append) noexcept;
    bool isOpen() const noexcept { return descriptor_ >= 0; }
    void write(const char* text, std::size_t size) noexcept;
    void flush() noexcept;
    void close() noexcept;

private:
    int descriptor_ = -1;
    std::size_t used_ = 0;
    char buffer_[4096];
};

}  // namespace detail
}  // namespace RTT
#endif
