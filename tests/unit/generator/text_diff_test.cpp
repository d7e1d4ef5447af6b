// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <support/text_diff.hpp>

#include <gtest/gtest.h>

namespace oroforge::test {
namespace {

TEST(UnifiedDiff, IsEmptyForEqualTexts) { EXPECT_EQ(unifiedDiff("a\nb\n", "a\nb\n", "f"), ""); }

TEST(UnifiedDiff, ShowsTheChangeInItsContext) {
    EXPECT_EQ(unifiedDiff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n", "f"),
              "--- f\n+++ actual\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
}

TEST(UnifiedDiff, ShowsANewFile) { EXPECT_EQ(unifiedDiff("", "a\n", "f"), "--- f\n+++ actual\n@@ -0,0 +1,1 @@\n+a\n"); }

TEST(UnifiedDiff, SeesAMissingEndOfLine) {
    EXPECT_EQ(unifiedDiff("a\n", "a", "f"), "--- f\n+++ actual\n@@ -1,1 +1,1 @@\n-a\n+a  (no end of line)\n");
}

}  // namespace
}  // namespace oroforge::test
