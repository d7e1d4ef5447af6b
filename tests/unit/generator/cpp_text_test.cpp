// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/cpp_text.hpp>

#include <gtest/gtest.h>

namespace oroforge::view {
namespace {

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
