// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/cpp_text.hpp>

#include <gtest/gtest.h>

namespace oroforge::view {
namespace {

TEST(StringLiteral, EscapesWhatCppReads) { EXPECT_EQ(stringLiteral("a\"b\\c\nd"), "\"a\\\"b\\\\c\\nd\""); }

TEST(CommentLines, CannotSwallowCode) {
    EXPECT_EQ(commentLines("\n  one\n  two \\\n"), (std::vector<std::string>{"one", "two \\ ."}));
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

TEST(PackageNames, BecomeIdentifiersAndClasses) {
    EXPECT_EQ(identifier("my-pkg.x"), "my_pkg_x");
    EXPECT_EQ(className("mypkg"), "Mypkg");
    EXPECT_EQ(className("my-pkg"), "My_pkg");
    EXPECT_EQ(guardName("my-pkg/a.hpp"), "MY_PKG_A_HPP");
}

TEST(IncludeName, IsRelativeToTheIncludeDirectory) {
    EXPECT_EQ(includeName("include/tank/t.hpp", "tank"), "tank/t.hpp");
    EXPECT_EQ(includeName("lib/include/other/sub/t.hpp", "tank"), "other/sub/t.hpp");
    EXPECT_EQ(includeName("src/models/t.hpp", "tank"), "tank/models/t.hpp");
    EXPECT_EQ(includeName("src/tank/t.hpp", "tank"), "tank/t.hpp");
    EXPECT_EQ(includeName("include/t.hpp", "tank"), "tank/t.hpp");
    EXPECT_EQ(includeName("t.hpp", "tank"), "tank/t.hpp");
}

TEST(StandardHeaders, AreThoseOfTheNamesUsed) {
    EXPECT_EQ(standardHeaders({"std::vector<std::uint8_t>", "my::vectors"}),
              (std::vector<std::string>{"cstdint", "vector"}));
    EXPECT_TRUE(standardHeaders({"double", "std::stringish"}).empty());
}

}  // namespace
}  // namespace oroforge::view
