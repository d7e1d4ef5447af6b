// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds where the tags of an XML text are, and its first syntax error. The XML library tells lines only;
/// this scan tells columns, and words the errors.
#ifndef OROFORGE_XML_DETAIL_SCANNER_HPP
#define OROFORGE_XML_DETAIL_SCANNER_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::xml::detail {

struct AttributePlace {
    std::string name;
    diag::Location name_at;
    diag::Location value_at;
};

/// One start tag. Tags come in document order, which is also the order of a depth-first walk.
struct TagPlace {
    std::string name;
    diag::Location at;       ///< the '<'
    diag::Location text_at;  ///< first letter of its character data; line 0 if it has none
    std::vector<AttributePlace> attributes;
};

/// Stops at the first syntax error, reports it and returns false.
bool scan(const std::string& text, const std::string& file, diag::Sink& sink, std::vector<TagPlace>& tags);

}  // namespace oroforge::xml::detail

#endif
