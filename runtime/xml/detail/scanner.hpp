// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Parses an XML text into elements, up to the first syntax error.
#ifndef OROFORGE_XML_DETAIL_SCANNER_HPP
#define OROFORGE_XML_DETAIL_SCANNER_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include <diag/sink.hpp>
#include <xml/document.hpp>

namespace oroforge::xml::detail {

/// What happens to complete elements.
struct Building {
    Blanks blanks = Blanks::kept;
    bool keep = true;      ///< false: elements are dropped; only the syntax is checked
    ChildConsumer take{};  ///< if set, gets the children of the root
};

/// How deep elements may be nested, so that code that walks the tree has enough stack.
constexpr std::size_t maxDepth = 98;
/// How many attributes a tag may have. The limit exists because each is compared with all before it.
constexpr std::size_t maxAttributes = 1000;
/// How many names of elements and attributes are kept to be shared.
constexpr std::size_t maxSharedNames = 1000;

/// Returns the root. Stops at the first syntax error, reports it and returns nothing.
std::optional<Element> scan(const std::string& text, const std::string& file, diag::Sink& sink,
                            const Building& building);

}  // namespace oroforge::xml::detail

#endif
