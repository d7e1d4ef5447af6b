// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OS_LOGGER_CAPTURE_HPP
#define OROFORGE_TESTS_UNIT_OS_LOGGER_CAPTURE_HPP

#include <rtt/Logger.hpp>

#include <iostream>
#include <mutex>
#include <ostream>
#include <string>

namespace oroforge::test {

/** What the Logger shows on the console, from Warning on, while this lives. Read and written by any thread. */
class LoggerCapture {
public:
    LoggerCapture() {
        RTT::Logger::Instance()->setLogLevel(RTT::Logger::Warning);
        RTT::Logger::Instance()->setStdStream(console_);
    }
    ~LoggerCapture() {
        RTT::Logger::Instance()->setStdStream(std::cerr);
        RTT::Logger::Instance()->setLogLevel(level_);
    }
    std::string text() const { return buffer_.text(); }
    int count(const std::string& what) const {
        const std::string all = text();
        int found = 0;
        for (auto at = all.find(what); at != std::string::npos; at = all.find(what, at + 1)) ++found;
        return found;
    }

private:
    class Buffer : public std::streambuf {
    public:
        std::string text() const {
            std::lock_guard<std::mutex> lock(mutex_);
            return text_;
        }

    private:
        std::streamsize xsputn(const char* from, std::streamsize count) override {
            std::lock_guard<std::mutex> lock(mutex_);
            text_.append(from, static_cast<std::size_t>(count));
            return count;
        }
        int_type overflow(int_type c) override {
            const char one = traits_type::to_char_type(c);
            return xsputn(&one, 1), c;
        }
        mutable std::mutex mutex_;
        std::string text_;
    };
    const RTT::Logger::LogLevel level_ = RTT::Logger::Instance()->getLogLevel();
    Buffer buffer_;
    std::ostream console_{&buffer_};
};

}  // namespace oroforge::test
#endif
