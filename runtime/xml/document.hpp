// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads XML with the place of every element and attribute. The XML library is hidden behind this header.
#ifndef OROFORGE_XML_DOCUMENT_HPP
#define OROFORGE_XML_DOCUMENT_HPP

#include <optional>
#include <string>

#include <xml/element.hpp>

namespace oroforge::xml {

/// A well-formed document with exactly one root element. A plain value: copyable, no hidden state.
class Document {
public:
    /// Malformed or unreadable input gives one located error (codes XML…) and no document.
    static std::optional<Document> parseFile(const std::string& path, diag::Sink& sink);

    /// `name` stands for the file name in diagnostics.
    static std::optional<Document> parseText(const std::string& text, const std::string& name, diag::Sink& sink);

    const Element& root() const { return root_; }

private:
    explicit Document(Element root) : root_(std::move(root)) {}
    Element root_;
};

}  // namespace oroforge::xml

#endif
