// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "log_capture.hpp"

#include <rtt/Logger.hpp>

#include <iostream>

namespace flow_test {

LogCapture::LogCapture() { RTT::Logger::Instance()->setStdStream(stream_); }

std::string LogCapture::finish() {
    RTT::Logger::Instance()->logflush();
    RTT::Logger::Instance()->setStdStream(std::cerr);
    return stream_.str();
}

LogCapture::~LogCapture() { RTT::Logger::Instance()->setStdStream(std::cerr); }

}  // namespace flow_test
