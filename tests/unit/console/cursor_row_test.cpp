// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <console/cursor_row.hpp>

#include <gtest/gtest.h>

#include <clocale>
#include <utility>

namespace {

using OCL::console::CursorRow;
typedef std::pair<std::size_t, std::size_t> Place;

class Cursor : public testing::Test {
protected:
    Cursor() { std::setlocale(LC_CTYPE, "C.UTF-8"); }
    ~Cursor() override { std::setlocale(LC_CTYPE, "C"); }
    /** Row and column behind the text, in rows of ten letters. */
    static Place after(const std::string& text) {
        CursorRow cursor(10);
        cursor.add(text);
        return {cursor.row(), cursor.column()};
    }
};

TEST_F(Cursor, GoesToTheNextRowWhenOneIsFull) {
    EXPECT_EQ(Place(0, 0), after(""));
    EXPECT_EQ(Place(0, 9), after("123456789"));
    EXPECT_EQ(Place(1, 0), after("1234567890"));
    EXPECT_EQ(Place(2, 5), after("1234567890123456789012345"));
}

TEST_F(Cursor, IsMovedByEndsOfLinesAndTabs) {
    EXPECT_EQ(Place(1, 2), after("123\n45"));
    EXPECT_EQ(Place(0, 2), after("12345\r12"));
    EXPECT_EQ(Place(0, 8), after("123\t"));
}

TEST_F(Cursor, IsNotMovedByColours) { EXPECT_EQ(Place(0, 3), after("\033[1;36mabc\033[0m")); }

TEST_F(Cursor, LettersTakeTheirColumns) {
    EXPECT_EQ(Place(0, 3), after("äöü"));
    EXPECT_EQ(Place(0, 4), after("日本"));
    EXPECT_EQ(Place(1, 2), after("123456789日"));  // none is divided
    EXPECT_EQ(Place(0, 1), after("e\u0301"));
    EXPECT_EQ(Place(0, 2), after("\001"));
    EXPECT_EQ(Place(0, 2), after("\xff"
                                 "a"));
}

}  // namespace
