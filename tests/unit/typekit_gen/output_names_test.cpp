// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/output_names.hpp>

#include <set>

#include <gtest/gtest.h>

using namespace oroforge::typekit;

TEST(OutputNames, DependOnTheTypekitNameOnly) {
    EXPECT_EQ(outputNames("demo"), (std::vector<std::string>{"Plugin.cpp", "types_0.cpp", "types_1.cpp", "types_2.cpp",
                                                             "types_3.cpp", "types/demo/typekit/Types.hpp"}));
}

TEST(BucketOf, NeverChanges) {
    // Generated trees that are committed move if these do.
    EXPECT_EQ(bucketOf("/demo/Point"), 0U);
    EXPECT_EQ(bucketOf("/demo/Mode"), 1U);
    EXPECT_EQ(bucketOf("/demo/Base"), 3U);
}

TEST(BucketOf, SpreadsNames) {
    std::set<std::size_t> used;
    for (int i = 0; i < 50; ++i) used.insert(bucketOf("/demo/T" + std::to_string(i)));
    EXPECT_EQ(used.size(), kBuckets);
}
