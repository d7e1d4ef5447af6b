// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/cpp_type.hpp>
#include <model/literal.hpp>

#include <gtest/gtest.h>

namespace oroforge::model {
namespace {

TEST(Classify, KnowsBuiltInTypesHoweverWritten) {
    EXPECT_EQ(classify("double"), TypeClass::Double);
    EXPECT_EQ(classify(" unsigned  int "), TypeClass::Unsigned);
    EXPECT_EQ(classify("std::uint8_t"), TypeClass::Unsigned);
    EXPECT_EQ(classify("uint8_t"), TypeClass::Unsigned);
    EXPECT_EQ(classify("::std::int64_t"), TypeClass::Signed);
    EXPECT_EQ(classify("std::string"), TypeClass::String);
    EXPECT_EQ(classify("tank::LevelSample"), TypeClass::Other);
    EXPECT_EQ(classify("std::vector<double>"), TypeClass::Other);
}

TEST(Normalised, KeepsOnlyBlanksBetweenWords) {
    EXPECT_EQ(normalised(" std::vector< unsigned  int > "), "std::vector<unsigned int>");
    EXPECT_EQ(normalised("const T &"), "const T&");
}

TEST(Identifier, RefusesDigitsFirstAndSigns) {
    EXPECT_TRUE(isIdentifier("_a1"));
    EXPECT_FALSE(isIdentifier(""));
    EXPECT_FALSE(isIdentifier("1a"));
    EXPECT_FALSE(isIdentifier("a-b"));
    EXPECT_TRUE(isKeyword("requires"));
    EXPECT_FALSE(isKeyword("level"));
}

TEST(SplitQualified, SplitsAtColons) {
    EXPECT_EQ(splitQualified("a::b::C"), (std::vector<std::string>{"a", "b", "C"}));
    EXPECT_EQ(splitQualified("C"), std::vector<std::string>{"C"});
    EXPECT_EQ(splitQualified("::C"), (std::vector<std::string>{"", "C"}));
}

TEST(Literals, FollowTheirNotation) {
    for (const char* good : {"0", "-1.5", "+.5", "1.", "1e9", "1.5E-3"}) EXPECT_TRUE(isNumberText(good)) << good;
    for (const char* bad : {"", ".", "-", "1e", "0x1", "1,5", "nan", "inf", " 1"})
        EXPECT_FALSE(isNumberText(bad)) << bad;
    EXPECT_TRUE(isIntegerText("-12"));
    EXPECT_FALSE(isIntegerText("1.0"));
    EXPECT_FALSE(isBooleanText("1"));
}

}  // namespace
}  // namespace oroforge::model
