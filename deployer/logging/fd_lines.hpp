// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Records to a file descriptor.
#ifndef OROFORGE_LOGGING_FD_LINES_HPP
#define OROFORGE_LOGGING_FD_LINES_HPP

#include "line_appender.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace OCL::logging {

/**
 * Collects records and writes several with one write(). The kernel ends a write at the end of a page if the process is
 * killed, so a group of records never crosses one; only a single record does.
 */
class FdLines : public LineAppender {
public:
    explicit FdLines(const std::string& owner) : LineAppender(owner) {}
    void flush() override;

protected:
    void write(const log4cpp::LoggingEvent& event, const std::string& record) override;
    /** Called before a group is written; false, with the reason, if there is no descriptor. */
    virtual bool prepare(std::string& error) = 0;
    void close() override {}

    /** Where the next record will begin. */
    std::uint64_t end() const { return position_ + text_.size(); }

    int file_ = -1;
    std::uint64_t position_ = 0;  // after the last group

private:
    std::size_t writeAll(std::string& error) const;
    void takeBack(std::size_t bytes) const;

    std::string text_;
    std::vector<std::size_t> ends_;  // of each record in text_
};

/** Standard output. */
class OutputLines final : public FdLines {
public:
    explicit OutputLines(const std::string& owner);

private:
    bool prepare(std::string& error) override;
    std::string target() const override { return "standard output"; }
};

}  // namespace OCL::logging

#endif
