// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Resolves entities and character references, and collects character data.
#ifndef OROFORGE_XML_DETAIL_REFERENCES_HPP
#define OROFORGE_XML_DETAIL_REFERENCES_HPP

#include <cstddef>
#include <string>

namespace oroforge::xml::detail {

/// Appends the value of the reference at the '&' and returns its length in the source; 0 if it is not a known
/// reference.
std::size_t appendReference(const char* at, std::string& to);

/// The value of an attribute from its source text, with references resolved.
std::string resolved(const char* raw);

/// Collects the character data of one element, piece by piece. Blanks written as references or in CDATA count as
/// letters.
class TextCollector {
public:
    /// With `condense`, blanks between words become one space.
    explicit TextCollector(bool condense) : condense_(condense) {}

    void addText(const char* raw);
    void addCdata(const char* text);
    /// The collected text without the blanks at both ends.
    std::string finish();

private:
    /// Must be called before a letter is appended.
    void beginLetter();

    std::string text_;
    std::size_t kept_ = 0;  // length of text_ up to its last letter
    bool condense_;
    bool started_ = false;
    bool blank_ = false;  // condensed blanks wait for a letter
};

}  // namespace oroforge::xml::detail

#endif
