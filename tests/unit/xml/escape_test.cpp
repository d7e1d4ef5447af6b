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
    for (int c = 0; c != 128; ++c) text += static_cast<char>(c);
    text += "  x \n \xc3\xb6\xe2\x82\xac ";
    const std::string document = "<a t=\"" + escapeExactly(text, true) + "\">\n " + escapeExactly(text) + "\n</a>";

    for (const Blanks blanks : {Blanks::kept, Blanks::condensed}) {
        diag::Sink sink;
        const auto read = Document::parseText(document, "f", sink, blanks);
        ASSERT_TRUE(read.has_value());
        EXPECT_EQ(read->root().text, text);
        EXPECT_EQ(read->root().attribute("t")->value, text);
    }
}

TEST(Escape, BytesThatAreNoUtf8BecomeTheirLettersInLatin1) {
    for (const auto& [text, utf8] : std::vector<std::pair<std::string, std::string>>{
             {"K\xf6rper", "K\xc3\xb6rper"}, {"\x80\xff", "\xc2\x80\xc3\xbf"}, {"\xe2\x82", "\xc3\xa2\xc2\x82"}}) {
        diag::Sink sink;
        const auto read =
            Document::parseText("<a t=\"" + escapeAttribute(text) + "\">" + escapeText(text) + "</a>", "f", sink);
        ASSERT_TRUE(read.has_value());
        EXPECT_EQ(read->root().text, utf8);
        EXPECT_EQ(read->root().attribute("t")->value, utf8);
        EXPECT_EQ(asUtf8(text), utf8);
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
