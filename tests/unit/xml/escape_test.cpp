// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/document.hpp>
#include <xml/escape.hpp>

#include <gtest/gtest.h>

namespace oroforge::xml {
namespace {

TEST(Escape, TextKeepsQuotesAndLines) { EXPECT_EQ(escapeText("a<b>\"&\n"), "a&lt;b&gt;\"&amp;\n"); }

TEST(Escape, AttributeKeepsNothingThatReadingWouldChange) {
    EXPECT_EQ(escapeAttribute("\"<\t\n"), "&quot;&lt;&#9;&#10;");
}

TEST(Escape, DropsWhatXmlCannotCarry) { EXPECT_EQ(escapeText(std::string("a\x01") + "b"), "ab"); }

TEST(Escape, ExactTextKeepsSingleSpacesReadable) {
    EXPECT_EQ(escapeExactly("a b  c\n"), "a b &#32;c&#10;");
    EXPECT_EQ(escapeExactly(" \"<"), "&#32;\"&lt;");
    EXPECT_EQ(escapeExactly("\"\x01", true), "&quot;&#1;");
}

TEST(Escape, ExactTextIsReadBackHoweverBlanksAreRead) {
    std::string text;
    for (int c = 0; c != 256; ++c) text += static_cast<char>(c);
    text += "  x \n ";
    const std::string document = "<a t=\"" + escapeExactly(text, true) + "\">\n " + escapeExactly(text) + "\n</a>";

    for (const Blanks blanks : {Blanks::kept, Blanks::condensed}) {
        diag::Sink sink;
        const auto read = Document::parseText(document, "f", sink, blanks);
        ASSERT_TRUE(read.has_value());
        EXPECT_EQ(read->root().text, text);
        EXPECT_EQ(read->root().attribute("t")->value, text);
    }
}

TEST(Escape, WhatIsWrittenIsReadBack) {
    const std::string text = "x < y && \"z\"\n\t'q'";
    diag::Sink sink;

    const auto document =
        Document::parseText("<a t=\"" + escapeAttribute(text) + "\">" + escapeText(text) + "</a>", "f", sink);

    ASSERT_TRUE(document.has_value());
    EXPECT_EQ(document->root().text, text);
    EXPECT_EQ(document->root().attribute("t")->value, text);
}

}  // namespace
}  // namespace oroforge::xml
