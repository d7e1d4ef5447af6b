// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the model makes of texts and names of the user.
#include <model/doc_text.hpp>
#include <model/literal.hpp>
#include <model/names.hpp>

#include <gtest/gtest.h>

namespace oroforge::model {
namespace {

TEST(StringLiteral, EscapesWhatCppReads) { EXPECT_EQ(stringLiteral("a\"b\\c\nd"), "\"a\\\"b\\\\c\\nd\""); }

TEST(CommentLines, CannotSwallowCode) {
    EXPECT_EQ(commentLines("\n  one\n  two \\\n"), (std::vector<std::string>{"one", "two \\ ."}));
    EXPECT_EQ(commentLines("one\rtwo"), std::vector<std::string>{"onetwo"});
}

TEST(ValueLiteral, HasTheTypeOfTheMember) {
    EXPECT_EQ(valueLiteral("1.5", "double"), "1.5");
    EXPECT_EQ(valueLiteral("1", "double"), "1.0");
    EXPECT_EQ(valueLiteral("1", "float"), "1.0F");
    EXPECT_EQ(valueLiteral("1e3", "float"), "1e3F");
    EXPECT_EQ(valueLiteral("+5", "unsigned int"), "5U");
    EXPECT_EQ(valueLiteral("true", "bool"), "true");
    EXPECT_EQ(valueLiteral("x\"y", "std::string"), "\"x\\\"y\"");
    EXPECT_EQ(valueLiteral("'", "char"), "'\\''");
    EXPECT_EQ(valueLiteral("{1, 2}", "std::vector<double>"), "{1, 2}");
}

TEST(DocWithUnit, PutsTheUnitBehind) {
    EXPECT_EQ(docWithUnit("The\n level", "m"), "The level [m]");
    EXPECT_EQ(docWithUnit("", "m"), "[m]");
    EXPECT_EQ(docWithUnit("The level", ""), "The level");
}

TEST(Names, AreMadeOfThePathOfServices) {
    const ServicePath path = {"gripper", "left"};
    EXPECT_EQ(fullName(path, "open"), "gripper.left.open");
    EXPECT_EQ(methodName(path, "open"), "gripper_left_open");
    EXPECT_EQ(memberName(methodName({}, "level")), "level_");
    EXPECT_EQ(accessTo(path), "provides(\"gripper\")->provides(\"left\")->");
    EXPECT_EQ(accessTo({}), "");
}

TEST(Names, OfClassesAreTakenApart) {
    EXPECT_EQ(namespaceOf("a::b::C"), "a::b");
    EXPECT_EQ(namespaceOf("C"), "");
    EXPECT_EQ(lastName("a::b::C"), "C");
    EXPECT_EQ(baseName("a::C"), "a::CBase");
}

}  // namespace
}  // namespace oroforge::model
