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
