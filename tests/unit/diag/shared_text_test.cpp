// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <gtest/gtest.h>

#include <set>
#include <string>

#include <diag/shared_text.hpp>

using oroforge::diag::SharedText;

TEST(SharedText, CopiesReferToTheSameText) {
    const SharedText first(std::string(1000, 'a'));
    const SharedText copy = first;
    EXPECT_EQ(&first.str(), &copy.str());
    EXPECT_EQ(sizeof copy, sizeof(void*));
}

TEST(SharedText, IsComparedByItsLetters) {
    EXPECT_EQ(SharedText("a"), SharedText(std::string("a")));
    EXPECT_NE(SharedText("a"), SharedText("b"));
    EXPECT_EQ(SharedText("a"), std::string("a"));
    EXPECT_NE(SharedText("a"), "b");
    EXPECT_EQ((std::set<SharedText>{"b", "a", "b"}).size(), 2U);
}

TEST(SharedText, NothingIsEmpty) {
    EXPECT_TRUE(SharedText().empty());
    EXPECT_EQ(SharedText(), SharedText(""));
    EXPECT_EQ("<" + SharedText() + ">", "<>");
}
