// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/nearest_match.hpp>
#include <diag/type_match.hpp>

#include <gtest/gtest.h>

namespace oroforge::diag {
namespace {

TEST(EditDistance, CountsChanges) {
    EXPECT_EQ(editDistance("", ""), 0U);
    EXPECT_EQ(editDistance("abc", ""), 3U);
    EXPECT_EQ(editDistance("port", "prot"), 1U);
    EXPECT_EQ(editDistance("port", "ports"), 1U);
    EXPECT_EQ(editDistance("Port", "port"), 0U);
}

TEST(NearestMatch, FindsALikelySlip) {
    EXPECT_EQ(nearestMatch("propery", {"port", "property", "operation"}), "property");
    EXPECT_EQ(nearestMatch("Name", {"type", "name"}), "name");
}

TEST(NearestMatch, FindsNothingInStrangers) {
    EXPECT_EQ(nearestMatch("colour", {"name", "type"}), std::nullopt);
    EXPECT_EQ(nearestMatch("x", {"y"}), std::nullopt);
    EXPECT_EQ(nearestMatch("x", {}), std::nullopt);
}

TEST(DidYouMean, IsAHintOrNothing) {
    EXPECT_EQ(didYouMean("prot", {"port"}), "; did you mean 'port'?");
    EXPECT_EQ(didYouMean("colour", {"port"}), "");
}

TEST(DidYouMeanType, LooksForTheNameInNamespacesFirst) {
    EXPECT_EQ(didYouMeanType("Arm", {"Art", "far::Farm", "robot::Arm"}), "; did you mean 'robot::Arm'?");
    EXPECT_EQ(didYouMeanType("robot::Arm", {"Art", "Arm"}), "; did you mean 'Arm'?");
    EXPECT_EQ(didYouMeanType("robot::Amr", {"robot::Arm"}), "; did you mean 'robot::Arm'?");
    EXPECT_EQ(didYouMeanType("Arm", {"::Arm", "Wheel"}), "");
}

TEST(OneOf, JoinsChoices) {
    EXPECT_EQ(oneOf({"a"}), "'a'");
    EXPECT_EQ(oneOf({"a", "b", "c"}), "'a', 'b' or 'c'");
}

}  // namespace
}  // namespace oroforge::diag
