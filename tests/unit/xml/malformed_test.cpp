// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/print.hpp>
#include <xml/document.hpp>

#include <gtest/gtest.h>

namespace oroforge::xml {
namespace {

struct Case {
    const char* text;
    const char* expected;
};

class Malformed : public testing::TestWithParam<Case> {};

TEST_P(Malformed, GivesOneLocatedError) {
    diag::Sink sink;

    const auto document = Document::parseText(GetParam().text, "f.xml", sink);

    EXPECT_FALSE(document.has_value());
    ASSERT_EQ(sink.all().size(), 1U);
    EXPECT_EQ(diag::toString(sink.all()[0]), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Encoding, Malformed,
    testing::Values(
        Case{"<a>\x1b</a>", "f.xml:1:4: error: [XML009] found the control character 0x1b, expected text"},
        Case{"<a>\n<b x='\x01'/></a>", "f.xml:2:7: error: [XML009] found the control character 0x01, expected text"},
        Case{"<a/><!-- \x7f -->", "f.xml:1:10: error: [XML009] found the control character 0x7f, expected text"},
        Case{"<a>K\xf6rper</a>", "f.xml:1:5: error: [XML009] found the byte 0xf6, expected text in UTF-8"},
        Case{"<a>\xc0\xaf</a>", "f.xml:1:4: error: [XML009] found the byte 0xc0, expected text in UTF-8"},
        Case{"<a>\xed\xa0\x80</a>", "f.xml:1:4: error: [XML009] found the byte 0xed, expected text in UTF-8"},
        Case{"<a>\xe2\x82", "f.xml:1:4: error: [XML009] found the byte 0xe2, expected text in UTF-8"},
        Case{"\xff\xfe<", "f.xml:1:1: error: [XML009] the text is in UTF-16, expected UTF-8"},
        Case{"<?xml version='1.0' encoding='ISO-8859-1'?><a>\xf6</a>",
             "f.xml:1:31: error: [XML009] the encoding is 'ISO-8859-1', expected UTF-8"},
        Case{"<?xml version='1.0' encoding='latin1'?><a>\xc3\xb6</a>",
             "f.xml:1:31: error: [XML009] the encoding is 'latin1', expected UTF-8"},
        Case{"<?xml version=\"1.0\" encoding=\"EBCDIC\"?><a/>",
             "f.xml:1:31: error: [XML009] the encoding is 'EBCDIC', expected UTF-8"}));

TEST(Encoding, Utf8AndWhatIsPartOfItCanBeRead) {
    for (const char* text : {"<a>\t\r\n K\xc3\xb6rper \xe2\x82\xac \xf0\x9f\x99\x82</a>", "\xEF\xBB\xBF<a/>",
                             "<?xml version='1.0' encoding='utf-8'?><a>\xc3\xb6</a>",
                             "<?xml version='1.0' encoding='ISO-8859-1'?><a>ascii</a>"}) {
        diag::Sink sink;
        EXPECT_TRUE(Document::parseText(text, "f.xml", sink).has_value()) << text;
        EXPECT_TRUE(sink.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Xml, Malformed,
    testing::Values(
        Case{"", "f.xml:1:1: error: [XML005] found no element; expected one root element"},
        Case{"<!-- x -->", "f.xml:1:11: error: [XML005] found no element; expected one root element"},
        Case{"hello", "f.xml:1:1: error: [XML004] found text outside of the root element"},
        Case{"<a/>x", "f.xml:1:5: error: [XML004] found text outside of the root element"},
        Case{"<a/>\n<b/>", "f.xml:2:1: error: [XML005] found a second root element <b>, expected only one"},
        Case{"<a>\n<b>\n</a>", "f.xml:3:1: error: [XML003] found </a>, expected </b>"},
        Case{"<a>\n <b/>", "f.xml:1:1: error: [XML003] <a> is never closed; expected </a>"},
        Case{"</a>", "f.xml:1:1: error: [XML003] found </a>, but no element is open"},
        Case{"<a></a", "f.xml:1:7: error: [XML002] expected '>' at the end of </a>"},
        Case{"<a><!-- x </a>", "f.xml:1:4: error: [XML003] comment is never closed; expected '-->'"},
        Case{"<a><![CDATA[x</a>", "f.xml:1:4: error: [XML003] CDATA section is never closed; expected ']]>'"},
        Case{"<a\n<b/></a>", "f.xml:1:1: error: [XML002] start tag <a is not finished; expected '>'"},
        Case{"<a x/>", "f.xml:1:5: error: [XML002] expected '=' after attribute 'x'"},
        Case{"<a x=1/>", "f.xml:1:6: error: [XML002] the value of attribute 'x' is not in quotes"},
        Case{"<a x='1'y='2'/>", "f.xml:1:9: error: [XML002] expected white space before the next attribute"},
        Case{"<a x='1><b/></a>",
             "f.xml:1:6: error: [XML002] the value of attribute 'x' has no closing quote before the next '<'"},
        Case{"<a =''/>", "f.xml:1:4: error: [XML002] found '=' in <a>, expected an attribute name"},
        Case{"<a x='1' x='2'/>", "f.xml:1:10: error: [XML006] attribute 'x' is given twice"},
        Case{"<a>1 < 2</a>",
             "f.xml:1:6: error: [XML002] found '<' without an element name; write '&lt;' for the character"}));

TEST(Malformed, MismatchShowsWhereTheElementWasOpened) {
    diag::Sink sink;

    Document::parseText("<a>\n<b>\n</a>", "f.xml", sink);

    ASSERT_EQ(sink.all()[0].notes.size(), 1U);
    EXPECT_EQ(sink.all()[0].notes[0].message, "<b> opened here");
    EXPECT_EQ(sink.all()[0].notes[0].where.line, 2U);
}

TEST(Malformed, MissingFileIsReported) {
    diag::Sink sink;

    EXPECT_FALSE(Document::parseFile("/nowhere/f.xml", sink).has_value());
    EXPECT_EQ(diag::toString(sink.all()[0]),
              "/nowhere/f.xml: error: [XML001] cannot read the file: No such file or directory");
}

TEST(Malformed, DirectoryIsReported) {
    diag::Sink sink;

    EXPECT_FALSE(Document::parseFile("/", sink).has_value());
    EXPECT_EQ(sink.errorCount(), 1U);
}

std::string nested(int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<a>";
    for (int i = 0; i < depth; ++i) text += "</a>";
    return text;
}

TEST(Malformed, DeepNestingIsRefusedNotFatal) {
    for (const int depth : {99, 10000, 100000}) {
        diag::Sink sink;
        EXPECT_FALSE(Document::parseText(nested(depth), "f.xml", sink).has_value());
        EXPECT_EQ(diag::toString(sink.all()[0]), "f.xml:1:295: error: [XML007] elements are nested too deeply");
    }
    diag::Sink sink;
    EXPECT_TRUE(Document::parseText(nested(98), "f.xml", sink).has_value());
}

TEST(Malformed, ThousandsOfAttributesAreRefused) {
    std::string text = "<a";
    for (int i = 0; i < 100000; ++i) text += "\na" + std::to_string(i) + "=''";
    diag::Sink sink;

    EXPECT_FALSE(Document::parseText(text + "/>", "f.xml", sink).has_value());
    EXPECT_EQ(diag::toString(sink.all()[0]), "f.xml:1002:1: error: [XML008] <a> has more than 1000 attributes");
}

TEST(Malformed, ZeroBytesAreLocated) {
    diag::Sink sink;

    EXPECT_FALSE(Document::parseText(std::string("<a>\n x\0</a>", 12), "f.xml", sink).has_value());
    EXPECT_EQ(diag::toString(sink.all()[0]),
              "f.xml:2:3: error: [XML001] found a zero byte; expected XML text in UTF-8");
}

}  // namespace
}  // namespace oroforge::xml
