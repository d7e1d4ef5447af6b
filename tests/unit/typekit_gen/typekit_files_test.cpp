// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/typekit_files.hpp>

#include <set>

#include <gtest/gtest.h>
#include <plan/buckets.hpp>

using namespace oroforge::typekit;

TEST(OutputNames, DependOnTheTypekitNameOnly) {
    const std::vector<std::string> names = outputNames("demo");
    ASSERT_EQ(names.size(), 18U);
    EXPECT_EQ(names.front(), "Plugin.cpp");
    EXPECT_EQ(names[1], "types_0.cpp");
    EXPECT_EQ(names[16], "types_15.cpp");
    EXPECT_EQ(names.back(), "types/demo/typekit/Types.hpp");
}

TEST(BucketOf, NeverChanges) {
    // Generated trees that are committed move if these do.
    EXPECT_EQ(bucketOf("/demo/Point"), 12U);
    EXPECT_EQ(bucketOf("/demo/Mode"), 1U);
    EXPECT_EQ(bucketOf("/demo/Base"), 7U);
}

TEST(BucketOf, SpreadsNames) {
    std::set<std::size_t> used;
    for (int i = 0; i < 200; ++i) used.insert(bucketOf("/demo/T" + std::to_string(i)));
    EXPECT_EQ(used.size(), kBuckets);
}
