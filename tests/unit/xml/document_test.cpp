// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/document.hpp>

#include <gtest/gtest.h>

namespace oroforge::xml {
namespace {

Element parsed(const std::string& text) {
    diag::Sink sink;
    const auto document = Document::parseText(text, "f.xml", sink);
    EXPECT_TRUE(sink.empty());
    return document ? document->root() : Element{};
}

std::string at(const diag::Location& where) { return std::to_string(where.line) + ":" + std::to_string(where.column); }

TEST(Document, GivesElementsInOrder) {
    const Element root = parsed("<a><b/><c/><b/></a>");

    ASSERT_EQ(root.children.size(), 3U);
    EXPECT_EQ(root.children[1].name, "c");
    EXPECT_EQ(root.childrenNamed("b").size(), 2U);
    EXPECT_EQ(root.child("d"), nullptr);
}

TEST(Document, KnowsWhereElementsAndAttributesStand) {
    const Element root = parsed("<a>\n  <b one=\"1\"\n     two='2'/>\n</a>\n");
    const Element& b = root.children.front();

    EXPECT_EQ(b.where.file, "f.xml");
    EXPECT_EQ(at(b.where), "2:3");
    EXPECT_EQ(at(b.attribute("one")->where), "2:6");
    EXPECT_EQ(at(b.attribute("one")->valueWhere), "2:11");
    EXPECT_EQ(at(b.attribute("two")->where), "3:6");
    EXPECT_EQ(at(b.attribute("two")->valueWhere), "3:11");
}

TEST(Document, PlacesAreRightAfterCommentsCdataAndDeclarations) {
    const Element root = parsed(
        "<?xml version=\"1.0\"?>\n<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n<!-- <x> -->\n"
        "<a><![CDATA[<b>]]><!--<c>\n--><d/></a>");

    EXPECT_EQ(at(root.where), "4:1");
    ASSERT_EQ(root.children.size(), 1U);
    EXPECT_EQ(at(root.children[0].where), "5:4");
    EXPECT_EQ(root.text, "<b>");
    EXPECT_EQ(at(root.textWhere), "4:4");
}

TEST(Document, DeclarationsOfTheDocumentTypeAreReadOver) {
    for (const char* const type :
         {"<!DOCTYPE d [ <!-- [a]> --> <!ELEMENT d ANY> ]>", "<!DOCTYPE d SYSTEM \"a[b]>c.dtd\">",
          "<!DOCTYPE d [ <!ENTITY e \"]>\"> ]>", "<!DOCTYPE d>"})
        EXPECT_EQ(at(parsed(std::string(type) + "\n<a/>").where), "2:1") << type;
}

TEST(Document, TrimsTextAndResolvesEntities) {
    const Element root = parsed("<a x=\"&lt;&quot;\">\n   one &amp; two \n</a>");

    EXPECT_EQ(root.text, "one & two");
    EXPECT_EQ(at(root.textWhere), "2:4");
    EXPECT_EQ(root.attribute("x")->value, "<\"");
}

TEST(Document, BlanksAreKeptOrCondensed) {
    const std::string text = "<a> \n one  \t two<!-- x --> <![CDATA[ ]]>&#32;\n</a>";
    diag::Sink sink;

    EXPECT_EQ(Document::parseText(text, "f", sink)->root().text, "one  \t two  ");
    EXPECT_EQ(Document::parseText(text, "f", sink, Blanks::condensed)->root().text, "one two  ");
}

TEST(Document, ResolvesReferencesAndLeavesUnknownOnes) {
    const Element root =
        parsed("<a x=\"&#9;&apos;&#x20AC;&none;&\">&lt;&gt;&amp;&quot;&#0;&#x10FFFF;&#x110000;&#;&#x;&#65</a>");

    EXPECT_EQ(root.attribute("x")->value, "\t'\xE2\x82\xAC&none;&");
    EXPECT_EQ(root.text, std::string("<>&\"\0\xF4\x8F\xBF\xBF&#x110000;&#;&#x;&#65", 30));
}

TEST(Document, ExtentsAreThoseOfTheSource) {
    const std::string text = "<!-- c --><a><b x='y' >in</b ><c/></a>";
    const Element root = parsed(text);
    const auto piece = [&](std::size_t begin, std::size_t end) { return text.substr(begin, end - begin); };
    const Element &b = root.children[0], &c = root.children[1];

    EXPECT_EQ(piece(root.extent.begin, root.extent.end), text.substr(10));
    EXPECT_EQ(piece(b.extent.begin, b.extent.end), "<b x='y' >in</b >");
    EXPECT_EQ(piece(b.extent.contentBegin, b.extent.contentEnd), "in");
    EXPECT_EQ(piece(b.attributes[0].valueBegin, b.attributes[0].valueEnd), "y");
    EXPECT_EQ(piece(c.extent.begin, c.extent.end), "<c/>");
    EXPECT_TRUE(c.extent.isEmptyTag());
    EXPECT_FALSE(b.extent.isEmptyTag());
}

TEST(Document, CommentsEndWhereXmlSaysSo) {
    EXPECT_EQ(parsed("<a><!--><b/>--><c/></a>").children.size(), 1U);
    EXPECT_EQ(parsed("<a><!---><b/>--><c/></a>").children.size(), 1U);
}

TEST(Document, TakesManyElements) {
    std::string text = "<a>";
    for (int i = 0; i < 100000; ++i) text += "<b>x</b>";

    EXPECT_EQ(parsed(text + "</a>").children.size(), 100000U);
}

TEST(Document, SkipsAByteOrderMark) {
    const Element root = parsed("\xEF\xBB\xBF<a/>");

    EXPECT_EQ(root.name, "a");
    EXPECT_EQ(at(root.where), "1:1");
}

TEST(Document, ReadsCarriageReturns) {
    const Element root = parsed("<a>\r\n<b>x</b>\r\n</a>\r\n");

    EXPECT_EQ(at(root.children[0].where), "2:1");
    EXPECT_EQ(root.children[0].text, "x");
}

TEST(Element, AttributesHaveFallbacks) {
    const Element root = parsed("<a x='1'/>");

    EXPECT_EQ(root.attributeOr("x", "2"), "1");
    EXPECT_EQ(root.attributeOr("y", "2"), "2");
    EXPECT_FALSE(root.hasAttribute("y"));
}

TEST(Element, ReportsAMissingAttributeAtTheElement) {
    diag::Sink sink;
    const Element root = parsed("\n<a/>");

    EXPECT_EQ(root.requireAttribute("name", sink), nullptr);
    ASSERT_EQ(sink.errorCount(), 1U);
    EXPECT_EQ(sink.all()[0].code, "XML010");
    EXPECT_EQ(sink.all()[0].message, "<a> has no attribute 'name'");
    EXPECT_EQ(at(sink.all()[0].where), "2:1");
}

}  // namespace
}  // namespace oroforge::xml
