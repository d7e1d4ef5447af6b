// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_LINE_HPP
#define RTT_DETAIL_LOG_LINE_HPP

#include <rtt/Logger.hpp>

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace RTT {
namespace detail {

/** Collects the text of a line; keeps its memory for the next. In a real-time thread it cuts instead of growing. */
class LineBuffer : public std::streambuf {
public:
    LineBuffer();
    const std::string& text() const { return text_; }
    /** The number of characters that were cut off. */
    std::size_t cut() const { return cut_; }
    void append(const char* text, std::size_t size);
    void clear() {
        text_.clear();
        cut_ = 0;
    }

protected:
    int_type overflow(int_type c) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;

private:
    std::string text_;
    std::size_t cut_ = 0;
};

constexpr std::size_t kLongestThreadName = 32;

/** The line that one thread is composing. */
struct LogLine {
    LogLine();
    LineBuffer buffer;
    std::ostream stream{&buffer};
    bool opened = false;  // something may have been put into the stream
    LoggerLevel level = Info;
    /** Set by Logger::In, at this many hooks (HookInProgress) within each other. */
    char module[kLongestLogModule + 1] = "";
    static constexpr int kNoModule = -1;
    int depth = kNoModule;

    void setModule(const char* name, std::size_t size) noexcept;
    /** What comes in brackets, see Logger. May refer to `room`; valid until the thread leaves its hook or its In. */
    std::string_view origin(char (&room)[kLongestThreadName]) noexcept;
    /** Hands the line to the sink, if it may be logged, and begins the next one with the same level. */
    void finish(bool flush);

private:
    [[gnu::noinline]] void finishVisible(bool flush);
    std::string_view threadName(char (&room)[kLongestThreadName]) noexcept;

    // Of the thread, since this many forks.
    unsigned knownSince_ = 0;
    long thread_ = 0;
    bool inMain_ = false;
};

/** In a child of fork(), whose only thread has another id. */
void forgetThreadIds() noexcept;

/**
 * The line of the calling thread, made by its first use and destroyed with the thread. A real-time thread takes a line
 * that refillSpareLines() made, and allocates only if more than kSpareLines threads do so at once.
 */
LogLine& logLine();
constexpr unsigned kSpareLines = 8;
void refillSpareLines();

}  // namespace detail
}  // namespace RTT
#endif
