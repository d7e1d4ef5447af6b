// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds where the tags of an XML text are, and its first syntax error. The XML library tells lines only;
/// this scan tells columns, and words the errors.
#ifndef OROFORGE_XML_DETAIL_SCANNER_HPP
#define OROFORGE_XML_DETAIL_SCANNER_HPP

#include <string>
#include <string_view>
#include <vector>

#include <diag/sink.hpp>
#include <xml/element.hpp>

namespace oroforge::xml::detail {

/// As in diag::Location, without the name of the file, of which there would be too many copies.
struct Place {
    unsigned line = 0, column = 0;
};

struct AttributePlace {
    std::string_view name;  ///< in the text
    Place name_at;
    Place value_at;
    std::size_t value_begin = 0, value_end = 0;
};

/// One start tag. Tags come in document order, which is also the order of a depth-first walk.
struct TagPlace {
    std::string_view name;  ///< in the text
    Place at;               ///< the '<'
    Place text_at;          ///< first letter of its character data; line 0 if it has none
    Extent extent;
    std::size_t attributes_begin = 0, attributes_end = 0;  ///< in Places::attributes
};

/// Bytes of the text.
struct Span {
    std::size_t begin = 0, end = 0;
};

struct Places {
    std::vector<TagPlace> tags;
    std::vector<AttributePlace> attributes;  ///< of all tags, in the order of the source
    std::vector<Span> instructions;          ///< processing instructions and document types, which say nothing to us
};

/// How deep elements may be nested; the XML library goes no deeper.
constexpr std::size_t maxDepth = 98;
/// How many attributes a tag may have; the XML library compares each with all before it.
constexpr std::size_t maxAttributes = 1000;

/// Stops at the first syntax error, reports it and returns false.
bool scan(const std::string& text, const std::string& file, diag::Sink& sink, Places& places);

}  // namespace oroforge::xml::detail

#endif
