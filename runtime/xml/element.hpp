// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A parsed XML element with its places in the source.
#ifndef OROFORGE_XML_ELEMENT_HPP
#define OROFORGE_XML_ELEMENT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::xml {

/// The offset of a byte in the source, which is shorter than 4 GiB.
using Offset = std::uint32_t;

struct Attribute {
    diag::SharedText name;
    std::string value;                    ///< entities resolved
    diag::Location where;                 ///< first letter of the name
    diag::Location valueWhere;            ///< first letter of the value, inside the quotes
    Offset valueBegin = 0, valueEnd = 0;  ///< bytes of the source between the quotes
};

/// The bytes of an element in the source. The content of one without an end tag ("<a/>") is empty and at its end.
struct Extent {
    Offset begin = 0, contentBegin = 0, contentEnd = 0, end = 0;

    bool isEmptyTag() const { return contentBegin == end; }
};

struct Element {
    diag::SharedText name;
    std::vector<Attribute> attributes;  ///< in the order of the source
    std::vector<Element> children;      ///< in the order of the source
    std::string text;                   ///< own character data and CDATA; see Blanks
    diag::Location where;               ///< the '<' of the start tag
    diag::Location textWhere;           ///< first letter of `text`; the start tag if there is none
    Extent extent;

    const diag::Location& location() const { return where; }

    /// The attribute of that name; null if there is none.
    const Attribute* attribute(const std::string& name) const;
    bool hasAttribute(const std::string& name) const { return attribute(name) != nullptr; }
    std::string attributeOr(const std::string& name, const std::string& fallback) const;

    /// Reports XML010 at the element, and returns null, if the attribute is missing.
    const Attribute* requireAttribute(const std::string& name, diag::Sink& sink) const;

    /// The first child of that name; null if there is none.
    const Element* child(const std::string& name) const;
    std::vector<const Element*> childrenNamed(const std::string& name) const;
};

}  // namespace oroforge::xml

#endif
