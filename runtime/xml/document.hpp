// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads XML with the place of every element and attribute.
#ifndef OROFORGE_XML_DOCUMENT_HPP
#define OROFORGE_XML_DOCUMENT_HPP

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <xml/element.hpp>

namespace oroforge::xml {

/// What happens to spaces, tabs and line ends in character data. Those at both ends are always removed, unless they are
/// written as character references or in CDATA.
enum class Blanks {
    kept,       ///< they stay between words
    condensed,  ///< they become one space between words, as in property files
};

/// Returns the whole file. Reports XML001 and returns nothing if it cannot be read.
std::optional<std::string> readText(const std::string& path, diag::Sink& sink);

/// Takes the children of the root one after another, so that they need not be in memory all at once. The root that it
/// sees has only its name and attributes.
using ChildConsumer = std::function<void(const Element& root, Element&& child)>;

/// A well-formed document with exactly one root element. It is a plain value that can be copied.
class Document {
public:
    /// Reports one error with a place (codes XML…) and returns nothing if the file is malformed or unreadable.
    static std::optional<Document> parseFile(const std::string& path, diag::Sink& sink, Blanks blanks = Blanks::kept);

    /// The same for a text, which diagnostics call `name`.
    static std::optional<Document> parseText(const std::string& text, const std::string& name, diag::Sink& sink,
                                             Blanks blanks = Blanks::kept);

    /// The same, but passes the children of the root to `take` instead of keeping them; none if the input is malformed.
    static std::optional<Document> parseText(const std::string& text, const std::string& name, diag::Sink& sink,
                                             Blanks blanks, const ChildConsumer& take);

    const Element& root() const { return root_; }

private:
    static std::optional<Document> document(std::optional<Element> root);

    explicit Document(Element root) : root_(std::move(root)) {}
    Element root_;
};

}  // namespace oroforge::xml

#endif
