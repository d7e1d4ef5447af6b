// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
//
//     text ─► scan (places, syntax) ─► tinyxml2 (tree) ─► Element tree: the two walked side by side
#include <xml/document.hpp>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include <tinyxml2.h>

#include <xml/detail/encoding.hpp>
#include <xml/detail/references.hpp>
#include <xml/detail/scanner.hpp>

namespace oroforge::xml {

namespace {

/// Joins the tree of the XML library with the places of its tags, which were scanned in the order of this walk.
class Conversion {
public:
    Conversion(const detail::Places& places, const std::string& file, Blanks blanks)
        : places_(places), next_(places.tags.begin()), file_(file), blanks_(blanks) {}

    /// False if the library and the scan saw different tags.
    bool good() const { return good_; }

    Element convert(const tinyxml2::XMLElement& source) {
        Element element;
        good_ = good_ && next_ != places_.tags.end() && next_->name == source.Name();
        if (!good_) return element;
        const detail::TagPlace& tag = *next_++;
        element.name = source.Name();
        element.where = inFile(tag.at);
        element.textWhere = inFile(tag.text_at.line == 0 ? tag.at : tag.text_at);
        element.extent = tag.extent;
        convertAttributes(source, tag, element);
        std::size_t count = 0;
        for (auto* c = source.FirstChildElement(); c != nullptr; c = c->NextSiblingElement()) ++count;
        element.children.reserve(count);
        detail::TextCollector text(blanks_ == Blanks::condensed);
        for (auto* node = source.FirstChild(); node != nullptr; node = node->NextSibling()) {
            if (const auto* child = node->ToElement()) {
                element.children.push_back(convert(*child));
            } else if (const auto* piece = node->ToText()) {
                piece->CData() ? text.addCdata(piece->Value()) : text.addText(piece->Value());
            }
        }
        element.text = text.finish();
        return element;
    }

private:
    diag::Location inFile(const detail::Place& place) const { return {file_, place.line, place.column}; }

    void convertAttributes(const tinyxml2::XMLElement& source, const detail::TagPlace& tag, Element& to) {
        auto at = places_.attributes.begin() + static_cast<std::ptrdiff_t>(tag.attributes_begin);
        const auto end = places_.attributes.begin() + static_cast<std::ptrdiff_t>(tag.attributes_end);
        to.attributes.reserve(tag.attributes_end - tag.attributes_begin);
        for (auto* a = source.FirstAttribute(); a != nullptr; a = a->Next(), ++at) {
            good_ = good_ && at != end && at->name == a->Name();
            if (!good_) return;
            to.attributes.push_back(Attribute{a->Name(), detail::resolved(a->Value()), inFile(at->name_at),
                                              inFile(at->value_at), at->value_begin, at->value_end});
        }
    }

    const detail::Places& places_;
    std::vector<detail::TagPlace>::const_iterator next_;
    const diag::FileName file_;
    Blanks blanks_;
    bool good_ = true;
};

std::string wording(tinyxml2::XMLError error) {
    switch (error) {
        case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE: return "found a malformed attribute";
        case tinyxml2::XML_ERROR_PARSING_TEXT: return "found malformed text";
        case tinyxml2::XML_ERROR_PARSING_DECLARATION: return "found <? where no declaration may stand";
        case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT: return "found an end tag that closes no open element";
        default: return "not well-formed XML";
    }
}

/// Blanks in the place of what the XML library does not take everywhere. Lines stay where they are.
std::string withoutInstructions(std::string text, const detail::Places& places) {
    for (const detail::Span& span : places.instructions)
        for (std::size_t i = span.begin; i != span.end; ++i)
            if (text[i] != '\n') text[i] = ' ';
    return text;
}

}  // namespace

std::optional<std::string> readText(const std::string& path, diag::Sink& sink) {
    std::ifstream in(path, std::ios::binary);
    const int reason = errno;
    std::error_code ignored;
    const bool isDirectory = std::filesystem::is_directory(path, ignored);
    if (!in || isDirectory) {
        sink.error(
            {path, 0, 0}, "XML001",
            "cannot read the file: " + (isDirectory ? "it is a directory" : std::generic_category().message(reason)));
        return std::nullopt;
    }
    std::string text;
    std::array<char, 1 << 16> piece;
    do {
        in.read(piece.data(), piece.size());
        text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    } while (in);
    return text;
}

std::optional<Document> Document::parseFile(const std::string& path, diag::Sink& sink, Blanks blanks) {
    const auto text = readText(path, sink);
    return text ? parseText(*text, path, sink, blanks) : std::nullopt;
}

std::optional<Document> Document::parseText(const std::string& text, const std::string& name, diag::Sink& sink,
                                            Blanks blanks) {
    if (!detail::checkEncoding(text, name, sink)) return std::nullopt;
    detail::Places places;
    if (!detail::scan(text, name, sink, places)) return std::nullopt;
    // References are resolved here, because afterwards blanks that were written as such could not be told from others.
    tinyxml2::XMLDocument source(false);
    const std::string parsed = withoutInstructions(text, places);
    if (source.Parse(parsed.data(), parsed.size()) != tinyxml2::XML_SUCCESS) {
        sink.error({name, static_cast<unsigned>(source.ErrorLineNum()), 0}, "XML002", wording(source.ErrorID()));
        return std::nullopt;
    }
    Conversion conversion(places, name, blanks);
    Document document(conversion.convert(*source.RootElement()));
    if (conversion.good()) return document;
    sink.error({name, places.tags.front().at.line, places.tags.front().at.column}, "XML002",
               wording(tinyxml2::XML_ERROR_PARSING));
    return std::nullopt;
}

}  // namespace oroforge::xml
