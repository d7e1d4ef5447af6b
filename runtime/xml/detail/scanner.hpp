// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// From an XML text to its elements, or to its first syntax error.
#ifndef OROFORGE_XML_DETAIL_SCANNER_HPP
#define OROFORGE_XML_DETAIL_SCANNER_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include <diag/sink.hpp>
#include <xml/document.hpp>

namespace oroforge::xml::detail {

/// What becomes of elements that are complete.
struct Building {
    Blanks blanks = Blanks::kept;
    bool keep = true;      ///< false: in no case; only syntax counts
    ChildConsumer take{};  ///< if there is one, children of the root go there
};

/// How deep elements may be nested, so that those who walk the tree have room on their stacks.
constexpr std::size_t maxDepth = 98;
/// How many attributes a tag may have: each is compared with all before it.
constexpr std::size_t maxAttributes = 1000;
/// How many names of elements and attributes are shared.
constexpr std::size_t maxSharedNames = 1000;

/// Stops at the first syntax error, reports it and returns nothing; else the root.
std::optional<Element> scan(const std::string& text, const std::string& file, diag::Sink& sink,
                            const Building& building);

}  // namespace oroforge::xml::detail

#endif
