// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
//
//     text ─► scan (places, syntax) ─► tinyxml2 (values) ─► Element tree: the two walked side by side
#include <xml/document.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include <tinyxml2.h>

#include <xml/detail/scanner.hpp>

namespace oroforge::xml {

namespace {

std::string trimmed(const std::string& text) {
    const char* spaces = " \t\r\n";
    const auto begin = text.find_first_not_of(spaces);
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(spaces) - begin + 1);
}

/// Takes one place per element: tags were scanned in the order of this walk.
using PlaceIterator = std::vector<detail::TagPlace>::const_iterator;

Element convert(const tinyxml2::XMLElement& source, PlaceIterator& place) {
    const detail::TagPlace& tag = *place++;
    Element element;
    element.name = source.Name();
    element.where = tag.at;
    element.textWhere = tag.text_at.line == 0 ? tag.at : tag.text_at;
    auto at = tag.attributes.begin();
    for (auto* a = source.FirstAttribute(); a != nullptr; a = a->Next(), ++at) {
        element.attributes.push_back(Attribute{a->Name(), a->Value(), at->name_at, at->value_at});
    }
    for (auto* node = source.FirstChild(); node != nullptr; node = node->NextSibling()) {
        if (const auto* child = node->ToElement()) {
            element.children.push_back(convert(*child, place));
        } else if (const auto* text = node->ToText()) {
            element.text += text->Value();
        }
    }
    element.text = trimmed(element.text);
    return element;
}

std::string wording(tinyxml2::XMLError error) {
    switch (error) {
        case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED: return "elements are nested too deeply";
        case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE: return "found a malformed attribute";
        case tinyxml2::XML_ERROR_PARSING_TEXT: return "found malformed text";
        case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT: return "found an end tag that closes no open element";
        default: return "not well-formed XML";
    }
}

}  // namespace

std::optional<Document> Document::parseFile(const std::string& path, diag::Sink& sink) {
    std::ifstream in(path, std::ios::binary);
    std::error_code ignored;
    if (!in || std::filesystem::is_directory(path, ignored)) {
        sink.error({path, 0, 0}, "XML001", "cannot read the file");
        return std::nullopt;
    }
    std::ostringstream text;
    text << in.rdbuf();
    return parseText(text.str(), path, sink);
}

std::optional<Document> Document::parseText(const std::string& text, const std::string& name, diag::Sink& sink) {
    std::vector<detail::TagPlace> tags;
    if (text.find('\0') != std::string::npos) {
        sink.error({name, 0, 0}, "XML001", "found a zero byte; expected XML text in UTF-8");
        return std::nullopt;
    }
    if (!detail::scan(text, name, sink, tags)) return std::nullopt;
    tinyxml2::XMLDocument source;
    if (source.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
        sink.error({name, static_cast<unsigned>(source.ErrorLineNum()), 0}, "XML002", wording(source.ErrorID()));
        return std::nullopt;
    }
    const tinyxml2::XMLElement* root = source.RootElement();
    PlaceIterator place = tags.begin();
    return Document(convert(*root, place));
}

}  // namespace oroforge::xml
