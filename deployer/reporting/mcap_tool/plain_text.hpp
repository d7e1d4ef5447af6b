// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPORTING_MCAP_PLAIN_TEXT_HPP
#define OROFORGE_REPORTING_MCAP_PLAIN_TEXT_HPP

#include <ostream>
#include <streambuf>

namespace oroforge::mcap {

/** Replaces the control characters that a stream gets by '?', except line ends and tabs, as long as this object
    exists: texts of a file of somebody else must not command the terminal. */
class PlainText : public std::streambuf {
public:
    explicit PlainText(std::ostream& stream);
    ~PlainText() override;
    PlainText(const PlainText&) = delete;
    PlainText& operator=(const PlainText&) = delete;

protected:
    int_type overflow(int_type letter) override;
    std::streamsize xsputn(const char* letters, std::streamsize count) override;
    int sync() override;

private:
    bool put(char letter);
    bool release();

    std::ostream& stream_;
    std::streambuf* const to_;
    bool held_ = false;  ///< the first byte of what may be a control character beyond ASCII
};

}  // namespace oroforge::mcap

#endif
