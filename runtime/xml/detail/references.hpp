// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Entities and character references, and the character data they stand in.
#ifndef OROFORGE_XML_DETAIL_REFERENCES_HPP
#define OROFORGE_XML_DETAIL_REFERENCES_HPP

#include <cstddef>
#include <string>

namespace oroforge::xml::detail {

/// Appends what the reference at the '&' stands for, and returns its length; 0 if there is none that is known.
std::size_t appendReference(const char* at, std::string& to);

/// An attribute's value as it stands in the source, references resolved.
std::string resolved(const char* raw);

/// The character data of one element, piece by piece. Blanks written as references or in CDATA count as letters.
class TextCollector {
public:
    /// `condense`: blanks between words become one space.
    explicit TextCollector(bool condense) : condense_(condense) {}

    void addText(const char* raw);
    void addCdata(const char* text);
    /// Without the blanks at both ends.
    std::string finish();

private:
    /// Call before a letter is appended.
    void beginLetter();

    std::string text_;
    std::size_t kept_ = 0;  // how much of text_ ends with a letter
    bool condense_;
    bool started_ = false;
    bool blank_ = false;  // condensed blanks wait for a letter
};

}  // namespace oroforge::xml::detail

#endif
