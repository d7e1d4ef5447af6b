// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_FRAME_TEXT_HPP
#define ORO_OCL_REPORTING_FRAME_TEXT_HPP

#include "fields.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace OCL::reporting {

/** The text on one line: control characters but TAB are written as `\n`, `\r` or `\xNN`. */
std::string onOneLine(std::string_view text);

/**
 * The rows of a report as lines of the protocol of TcpReporting, one part per name:
 *
 *     202 Machine.place
 *     202 x
 *     205 1.5
 */
class FrameText {
public:
    /** @param report what the records consist of: its parts are what is reported, by name */
    explicit FrameText(Field report);
    /** Sets what the next records consist of. What is reported must be the same, but may have other members. */
    void adopt(Field report) { report_ = std::move(report); }

    /** Makes the parts of a record. */
    void decode(const char* record, std::size_t size, int digits);
    /** The lines of a name, by its index; empty if the row leaves it out. */
    std::string_view part(std::size_t name) const;
    /** The names, each on one line. */
    const std::vector<std::string>& names() const { return lines_; }

private:
    struct Place {
        std::size_t begin = 0, size = 0;
    };
    Field report_;
    std::vector<std::string> lines_;
    std::vector<char> text_;
    std::vector<Place> parts_;
};

}  // namespace OCL::reporting

#endif
