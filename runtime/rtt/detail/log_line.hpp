// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_LINE_HPP
#define RTT_DETAIL_LOG_LINE_HPP

#include <rtt/Logger.hpp>

#include <ostream>
#include <streambuf>
#include <string>

namespace RTT {
namespace detail {

/** Appends to a string, which keeps its memory from line to line. */
class LineBuffer : public std::streambuf {
public:
    const std::string& text() const { return text_; }
    void clear() { text_.clear(); }

protected:
    int_type overflow(int_type c) override {
        if (!traits_type::eq_int_type(c, traits_type::eof())) text_.push_back(traits_type::to_char_type(c));
        return traits_type::not_eof(c);
    }
    std::streamsize xsputn(const char* text, std::streamsize size) override {
        text_.append(text, static_cast<std::size_t>(size));
        return size;
    }

private:
    std::string text_;
};

/** The line that one thread is composing. */
struct LogLine {
    LineBuffer buffer;
    std::ostream stream{&buffer};
    bool opened = false;  // something may have been put into the stream
    LoggerLevel level = Info;
    std::string module = "Logger";

    /** Hands the line to the sink, if it may be logged, and begins the next one with the same level. */
    void finish(bool flush);
};

/** The line of the calling thread; made with its first use, gone with the thread. */
LogLine& logLine();

}  // namespace detail
}  // namespace RTT
#endif
