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

/// What becomes of spaces, tabs and line ends in character data. Those at both ends are always cut off, unless they
/// are written as character references or in CDATA.
enum class Blanks {
    kept,       ///< between words they stay
    condensed,  ///< between words they become one space, as in property files
};

/// The whole file; an error (XML001), and nothing, if it cannot be read.
std::optional<std::string> readText(const std::string& path, diag::Sink& sink);

/// Takes one child of the root after the other, so that they need not be in memory all at once. The root that it sees has its
/// name and attributes only.
using ChildConsumer = std::function<void(const Element& root, Element&& child)>;

/// A well-formed document with exactly one root element. A plain value: copyable, no hidden state.
class Document {
public:
    /// Malformed or unreadable input gives one located error (codes XML…) and no document.
    static std::optional<Document> parseFile(const std::string& path, diag::Sink& sink, Blanks blanks = Blanks::kept);

    /// `name` stands for the file name in diagnostics.
    static std::optional<Document> parseText(const std::string& text, const std::string& name, diag::Sink& sink,
                                             Blanks blanks = Blanks::kept);

    /// The same, but `take` gets the children of the root, which has none afterwards; nothing is taken of malformed input.
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
