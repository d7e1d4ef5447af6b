// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "message_text.hpp"

namespace oroforge::messages {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Parsed {
    diag::Sink sink;
    Message message;
    explicit Parsed(const std::string& text) { message = parseMessage(text, "demo", "Demo", "msg/Demo.msg", sink); }
    std::string error() const { return sink.all().empty() ? "" : test::MessageFolder::textOf(sink.all()[0]); }
};

TEST(ParseMessage, fieldsOfEachForm) {
    const Parsed all(
        "# About it all.\n"
        "\n"
        "# How far it is.\n"
        "float64 distance\n"
        "uint8[4] part   # of the address\n"
        "Header header\n"
        "Point[] points\n"
        "other_msgs/Point point\n"
        "\ttime\tat\n");
    ASSERT_EQ(all.error(), "");
    const auto& fields = all.message.fields;
    ASSERT_EQ(fields.size(), 6u);
    EXPECT_EQ(fields[0].type.name, "float64");
    EXPECT_TRUE(fields[0].type.isBuiltin);
    EXPECT_EQ(fields[0].doc, "How far it is.");
    EXPECT_EQ(fields[0].where.line, 4u);
    EXPECT_EQ(fields[1].extent, Extent::Fixed);
    EXPECT_EQ(fields[1].count, 4u);
    EXPECT_EQ(fields[1].doc, "of the address");
    EXPECT_EQ(fields[1].written, "uint8[4]");
    EXPECT_EQ(fields[2].type.name, "std_msgs/Header");
    EXPECT_EQ(fields[3].type.name, "demo/Point");
    EXPECT_EQ(fields[3].extent, Extent::Any);
    EXPECT_FALSE(fields[3].type.isBuiltin);
    EXPECT_EQ(fields[4].type.name, "other_msgs/Point");
    EXPECT_EQ(fields[5].name, "at");
}

TEST(ParseMessage, constants) {
    const Parsed all(
        "int8 LOW=-128\n"
        "uint64 HIGH = 18446744073709551615 # most\n"
        "string TEXT= a # no comment  \n"
        "float32 HALF=0.5\n"
        "bool YES=True\n"
        "char LETTER=65\n");
    ASSERT_EQ(all.error(), "");
    const auto& constants = all.message.constants;
    ASSERT_EQ(constants.size(), 6u);
    EXPECT_EQ(constants[0].value, "-128");
    EXPECT_EQ(constants[1].name, "HIGH");
    EXPECT_EQ(constants[1].value, "18446744073709551615");
    EXPECT_EQ(constants[2].name, "TEXT");
    EXPECT_EQ(constants[2].value, "a # no comment");
    EXPECT_TRUE(all.message.fields.empty());
}

TEST(ParseMessage, emptyMessagesAndOtherLineEnds) {
    EXPECT_EQ(Parsed("").error(), "");
    EXPECT_EQ(Parsed("# nothing but \xc3\xa4 and \xff\r\n").error(), "");
    const Parsed windows("int32 a\r\nint32 b\r\n");
    ASSERT_EQ(windows.message.fields.size(), 2u);
    EXPECT_EQ(windows.message.fields[1].name, "b");
    EXPECT_EQ(windows.message.text, "int32 a\nint32 b\n");
    EXPECT_EQ(Parsed("int32 a\rint32 b").message.fields.size(), 2u);
}

TEST(ParseMessage, errorsHaveTheirPlace) {
    EXPECT_EQ(Parsed("int32 a\n  oops\n").error(),
              "Demo.msg:2:3: [RM002] 'oops' is not a field, which is a type and a name");
    EXPECT_THAT(Parsed("int32 9a").error(), StartsWith("Demo.msg:1:7: [RM002] '9a' cannot name a field"));
    EXPECT_THAT(Parsed("in-t a").error(), StartsWith("Demo.msg:1:1: [RM002] 'in-t' is not a type"));
    EXPECT_THAT(Parsed("a/b/c d").error(), HasSubstr("is not a type"));
    EXPECT_THAT(Parsed("int32 a b").error(), HasSubstr("'a b' cannot name a field"));
    EXPECT_THAT(Parsed("int32 a\nint8 a").error(), StartsWith("Demo.msg:2:6: [RM005] 'a' is in 'demo/Demo' already"));
}

TEST(ParseMessage, sizesOfArrays) {
    EXPECT_EQ(Parsed("int8[0] a").error(), "");
    EXPECT_EQ(Parsed("int8[268435456] a").error(), "");
    EXPECT_THAT(Parsed("int8[268435457] a").error(),
                StartsWith("Demo.msg:1:5: [RM003] an array of 268435457 elements"));
    EXPECT_THAT(Parsed("int8[99999999999999999999999] a").error(), HasSubstr("RM003"));
    for (const char* size : {"[-1]", "[x]", "[3", "[3]]", "[3][3]", "[1.5]", "[0x3]"})
        EXPECT_THAT(Parsed("int8" + std::string(size) + " a").error(), HasSubstr("is not the size of an array"))
            << size;
}

TEST(ParseMessage, valuesOfConstants) {
    EXPECT_THAT(Parsed("int8 A=128").error(),
                StartsWith("Demo.msg:1:7: [RM004] constant 'A': 128 does not fit into int8, which holds -128 to 127"));
    EXPECT_THAT(Parsed("uint8 A=-1").error(), HasSubstr("does not fit"));
    EXPECT_THAT(Parsed("uint64 A=18446744073709551616").error(), HasSubstr("does not fit"));
    EXPECT_THAT(Parsed("int32 A=1.5").error(), HasSubstr("not a whole number"));
    EXPECT_THAT(Parsed("int32 A=").error(), HasSubstr("no value"));
    EXPECT_THAT(Parsed("bool A=yes").error(), HasSubstr("write True or False"));
    EXPECT_THAT(Parsed("float32 A=x").error(), HasSubstr("'x' is not a number"));
    EXPECT_THAT(Parsed("time A=3").error(), HasSubstr("there are no constants of type time"));
    EXPECT_THAT(Parsed("Point A=3").error(), HasSubstr("'Point' cannot be the type of a constant"));
    EXPECT_THAT(Parsed("int32=3").error(), HasSubstr("cannot name a constant"));
}

TEST(ParseMessage, namesThatGencppCannotUse) {
    EXPECT_THAT(Parsed("int32 class").error(), StartsWith("Demo.msg:1:7: [RM005] 'class' cannot name a field of"));
    EXPECT_THAT(Parsed("int32 Ptr").error(), HasSubstr("gencpp"));
    EXPECT_THAT(Parsed("int32 A=1\nint32 A").error(), HasSubstr("RM005"));
    EXPECT_EQ(Parsed("int32 size\nint32 capacity\nint32 sec").error(), "");
}

TEST(ParseService, halves) {
    diag::Sink sink;
    const Service one =
        parseService("bool data\n---\n# so?\nbool success\nstring message\n", "demo", "Set", "Set.srv", sink);
    EXPECT_TRUE(sink.empty());
    EXPECT_EQ(one.request.fullName(), "demo/SetRequest");
    ASSERT_EQ(one.request.fields.size(), 1u);
    ASSERT_EQ(one.response.fields.size(), 2u);
    EXPECT_EQ(one.response.fields[0].where.line, 4u);
    const Service empty = parseService("---", "demo", "Set", "Set.srv", sink);
    EXPECT_TRUE(sink.empty());
    EXPECT_TRUE(empty.request.fields.empty());
    parseService("bool data\n", "demo", "Set", "Set.srv", sink);
    EXPECT_EQ(sink.errorCount(), 1u);
    parseService("---\n---\n", "demo", "Set", "Set.srv", sink);
    EXPECT_EQ(sink.errorCount(), 2u);
}

}  // namespace
}  // namespace oroforge::messages
