// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any bytes are read as XML: a document whose parts lie where its elements say, or one error with its place.
#include "fuzzing.hpp"

#include <xml/detail/encoding.hpp>
#include <xml/document.hpp>
#include <xml/escape.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace xml = oroforge::xml;
namespace diag = oroforge::diag;

namespace {

void checkPlaces(const xml::Element& element, const std::string& text) {
    const auto& extent = element.extent;
    require(extent.begin < extent.end && extent.end <= text.size(), "elements lie in the text");
    require(extent.begin < extent.contentBegin && extent.contentBegin <= extent.contentEnd &&
                extent.contentEnd <= extent.end,
            "contents lie in their elements");
    require(text.compare(extent.begin + 1, element.name.str().size(), element.name.str()) == 0,
            "elements begin with their names");
    require(text[extent.end - 1] == '>', "elements end with a tag");
    require(element.where.line != 0 && element.where.column != 0, "elements have places");
    for (const auto& attribute : element.attributes)
        require(attribute.valueBegin <= attribute.valueEnd && attribute.valueEnd < extent.contentBegin + 1,
                "values lie in their tags");
    xml::Offset at = extent.contentBegin;
    for (const auto& child : element.children) {
        require(at <= child.extent.begin && child.extent.end <= extent.contentEnd, "children lie in order");
        at = child.extent.end;
        checkPlaces(child, text);
    }
}

bool isUtf8(const std::string& text) {
    std::size_t at = 0;
    while (at != text.size()) {
        const std::size_t length = xml::detail::letterAt(text, at);
        if (length == 0) return false;
        at += length;
    }
    return true;
}

void checkEscaping(const std::string& text) {
    diag::Sink sink;
    const std::string written = "<a b=\"" + xml::escapeExactly(text, true) + "\">" + xml::escapeExactly(text) + "</a>";
    for (const auto blanks : {xml::Blanks::kept, xml::Blanks::condensed}) {
        const auto read = xml::Document::parseText(written, "written", sink, blanks);
        require(read.has_value(), "escaped text is XML");
        require(!isUtf8(text) || (read->root().text == text && read->root().attributes[0].value == text),
                "escaped text is read back");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    checkEscaping(text);
    for (const auto blanks : {xml::Blanks::kept, xml::Blanks::condensed}) {
        diag::Sink sink;
        const auto document = xml::Document::parseText(text, "input", sink, blanks);
        require(document.has_value() == sink.empty(), "there is a document or an error");
        if (document) {
            checkPlaces(document->root(), text);
        } else {
            require(sink.errorCount() == 1 && sink.all()[0].where.line != 0, "the error has a place");
        }
    }
    return 0;
}
