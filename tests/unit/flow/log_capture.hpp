// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the log's console gets during a test.
#ifndef OROFORGE_TESTS_FLOW_LOG_CAPTURE_HPP
#define OROFORGE_TESTS_FLOW_LOG_CAPTURE_HPP

#include <sstream>
#include <string>

namespace flow_test {

class LogCapture {
public:
    LogCapture();
    ~LogCapture();
    std::string text() const { return stream_.str(); }
    /** The whole text, also of threads whose lines come later; ends the capture. */
    std::string finish();
    bool contains(const std::string& part) const { return text().find(part) != std::string::npos; }

private:
    std::ostringstream stream_;
};

}  // namespace flow_test

#endif
