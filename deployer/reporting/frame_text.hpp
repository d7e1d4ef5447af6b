// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_FRAME_TEXT_HPP
#define ORO_OCL_REPORTING_FRAME_TEXT_HPP

#include <cstddef>
#include <string>
#include <string_view>
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
    /** @param names of what is reported, in the order of the rows */
    explicit FrameText(std::vector<std::string> names);

    /** Makes the parts of a record with names (see record.hpp). */
    void decode(const char* record, std::size_t size, int digits);
    /** The lines of a name, by its index; empty if the row does not have it. */
    std::string_view part(std::size_t name) const;
    /** The names, each on one line. */
    const std::vector<std::string>& names() const { return lines_; }

private:
    struct Place {
        std::size_t begin = 0, size = 0;
    };
    const std::vector<std::string> names_;
    std::vector<std::string> lines_;
    std::vector<char> text_, value_;
    std::vector<Place> parts_;
};

}  // namespace OCL::reporting

#endif
