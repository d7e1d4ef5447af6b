// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ast_text.hpp"

#include <gtest/gtest.h>

namespace {

using tests::complaints;
using tests::parsed;

TEST(ScriptLiteral, WholeNumbers) {
    EXPECT_EQ(parsed("0"), "0");
    EXPECT_EQ(parsed("2147483647"), "2147483647");
    EXPECT_EQ(parsed("007"), "7");
    EXPECT_EQ(parsed("1u"), "1u");
    EXPECT_EQ(parsed("4294967295u"), "4294967295u");
    EXPECT_EQ(parsed("9223372036854775807ll"), "9223372036854775807ll");
    EXPECT_EQ(parsed("18446744073709551615ull"), "18446744073709551615ull");
}

/// Their magnitudes do not fit.
TEST(ScriptLiteral, TheLeastNumbersAreWrittenWithTheirSign) {
    EXPECT_EQ(parsed("-2147483648"), "-2147483648");
    EXPECT_EQ(parsed("- 2147483648 + 1"), "(-2147483648 + 1)");
    EXPECT_EQ(parsed("-9223372036854775808ll"), "-9223372036854775808ll");
    EXPECT_EQ(parsed("-2147483648ll"), "(-2147483648ll)");
    EXPECT_EQ(parsed("-2147483647"), "(-2147483647)");
    for (const char* wrong : {"-2147483649", "-(2147483648)", "a - 2147483648", "-!2147483648", "-9223372036854775808"})
        EXPECT_NE(complaints(wrong), "") << wrong;
}

TEST(ScriptLiteral, HexadecimalNumbersAreUnsigned) {
    EXPECT_EQ(parsed("0xFF"), "255u");
    EXPECT_EQ(parsed("0XdeadBEEF"), "3735928559u");
    EXPECT_EQ(parsed("0x10u"), "16u");
    EXPECT_EQ(parsed("0x100000000ull"), "4294967296ull");
}

TEST(ScriptLiteral, RealNumbers) {
    EXPECT_EQ(parsed("1.5"), "1.5");
    EXPECT_EQ(parsed("1."), "1.0");
    EXPECT_EQ(parsed(".5"), "0.5");
    EXPECT_EQ(parsed("0."), "0.0");
    EXPECT_EQ(parsed("2e3"), "2000.0");
    EXPECT_EQ(parsed("2.5E-1"), "0.25");
    EXPECT_EQ(parsed("1.5f"), "1.5f");
    EXPECT_EQ(parsed("1.f"), "1.0f");
    EXPECT_EQ(parsed("5e-1f"), "0.5f");
}

TEST(ScriptLiteral, TimesAreSeconds) {
    EXPECT_EQ(parsed("3s"), "3.0");
    EXPECT_EQ(parsed("250ms"), "0.25");
    EXPECT_EQ(parsed("500000us"), "0.5");
    EXPECT_EQ(parsed("125000000ns"), "0.125");
    EXPECT_EQ(parsed("x = time"), "(x = time)");
}

TEST(ScriptLiteral, TruthValues) { EXPECT_EQ(parsed("true = false"), "(true = false)"); }

TEST(ScriptLiteral, Letters) {
    EXPECT_EQ(parsed("'a'"), "'a'");
    EXPECT_EQ(parsed("'\"'"), R"('\042')");
    EXPECT_EQ(parsed(R"('\n')"), R"('\012')");
    EXPECT_EQ(parsed(R"('\0')"), R"('\000')");
    EXPECT_EQ(parsed(R"('\'')"), R"('\047')");
}

TEST(ScriptLiteral, Texts) {
    EXPECT_EQ(parsed(R"("")"), R"("")");
    EXPECT_EQ(parsed(R"("a \"b\"")"), R"("a \042b\042")");
    EXPECT_EQ(parsed(R"("\n\r\t\a\b\f\v\\")"), R"("\012\015\011\007\010\014\013\134")");
    EXPECT_EQ(parsed(R"("\033[34;1mx\0")"), R"("\033[34;1mx\000")");
    EXPECT_EQ(parsed(R"("\1234")"), R"("S4")");
    EXPECT_EQ(parsed(R"("\x41\x4a1")"), R"("AJ1")");
    EXPECT_EQ(parsed("\"\xD0\xBF \xC3\xA9\""), "\"\xD0\xBF \xC3\xA9\"");
}

TEST(ScriptLiteral, NumbersThatDoNotFitAreErrors) {
    EXPECT_EQ(
        complaints("x = 2147483648"),
        "test.ops:1:5: error: [OPS006] found 2147483648, expected at most 2147483647; 'u' makes it unsigned, 'll' "
        "longer\n"
        "x = 2147483648\n"
        "    ^\n");
    EXPECT_EQ(complaints("4294967296u"),
              "test.ops:1:1: error: [OPS006] found 4294967296u, expected at most 4294967295; 'ull' makes it longer\n"
              "4294967296u\n"
              "^\n");
    EXPECT_EQ(complaints("0x1FFFFFFFF"),
              "test.ops:1:1: error: [OPS006] found 0x1FFFFFFFF, expected at most 4294967295; 'ull' makes it longer\n"
              "0x1FFFFFFFF\n"
              "^\n");
    EXPECT_EQ(
        complaints("9223372036854775808ll"),
        "test.ops:1:1: error: [OPS006] found 9223372036854775808ll, expected at most 9223372036854775807; 'ull' makes "
        "it unsigned\n"
        "9223372036854775808ll\n"
        "^\n");
    EXPECT_EQ(complaints("18446744073709551616ull"),
              "test.ops:1:1: error: [OPS006] found 18446744073709551616ull, expected at most 18446744073709551615\n"
              "18446744073709551616ull\n"
              "^\n");
    EXPECT_EQ(complaints("1e999"),
              "test.ops:1:1: error: [OPS006] found 1e999, expected a number that fits a double\n"
              "1e999\n"
              "^\n");
    EXPECT_EQ(complaints("1e99f"),
              "test.ops:1:1: error: [OPS006] found 1e99, expected a number that fits a float\n"
              "1e99f\n"
              "^\n");
}

TEST(ScriptLiteral, UnknownSuffixesAreErrors) {
    EXPECT_EQ(complaints("1f"),
              "test.ops:1:1: error: [OPS006] found '1f', expected a '.' before 'f'\n"
              "1f\n"
              "^\n");
    EXPECT_EQ(
        complaints("12min"),
        "test.ops:1:1: error: [OPS006] found 'min' after a whole number, expected 'u', 'll', 'ull', 's', 'ms', 'us' or "
        "'ns'\n"
        "12min\n"
        "^\n");
    EXPECT_EQ(
        complaints("1.5s"),
        "test.ops:1:1: error: [OPS006] found 's' after a number with fraction or exponent, expected 'f' or nothing\n"
        "1.5s\n"
        "^\n");
    EXPECT_EQ(complaints("0x"),
              "test.ops:1:1: error: [OPS006] found '0x', expected hexadecimal digits after '0x'\n"
              "0x\n"
              "^\n");
    EXPECT_EQ(complaints("0x1g"),
              "test.ops:1:1: error: [OPS006] found 'g', expected digits from 0 to f, 'u', 'll' or 'ull'\n"
              "0x1g\n"
              "^\n");
}

TEST(ScriptLiteral, WrongEscapesAreErrors) {
    EXPECT_EQ(complaints(R"(x = "ab\q\r\w")"),
              "test.ops:1:8: error: [OPS007] found '\\q', expected an escape such as '\\n', or '\\\\' for a backslash\n"
              "x = \"ab\\q\\r\\w\"\n"
              "       ^\n");
    EXPECT_EQ(complaints(R"("\777")"),
              "test.ops:1:2: error: [OPS007] found '\\777', expected at most '\\377'\n"
              "\"\\777\"\n"
              " ^\n");
    EXPECT_EQ(complaints(R"("\xg")"),
              "test.ops:1:2: error: [OPS007] found '\\x', expected two hexadecimal digits after it\n"
              "\"\\xg\"\n"
              " ^\n");
}

TEST(ScriptLiteral, LettersHaveOneByte) {
    EXPECT_EQ(
        complaints("'ab'"),
        "test.ops:1:1: error: [OPS007] found 'ab', expected one letter of one byte; put texts into double quotes\n"
        "'ab'\n"
        "^\n");
    EXPECT_EQ(complaints("''"),
              "test.ops:1:1: error: [OPS007] found '', expected one letter of one byte; put texts into double quotes\n"
              "''\n"
              "^\n");
}

TEST(ScriptLiteral, TextsThatDoNotEndAreErrors) {
    EXPECT_EQ(complaints("import(\"a)\nx = 'b"),
              "test.ops:1:8: error: [OPS004] found the end of the line, expected \" at the end of the text\n"
              "import(\"a)\n"
              "       ^\n"
              "test.ops:2:5: error: [OPS004] found the end of the line, expected ' at the end of the letter\n"
              "x = 'b\n"
              "    ^\n");
}

/// Each error in a literal is told, and what follows on the line is read.
TEST(ScriptLiteral, WrongLiteralsDoNotHideWhatFollows) {
    EXPECT_EQ(
        complaints("x = 1f + '' + \"\\q\" )"),
        "test.ops:1:5: error: [OPS006] found '1f', expected a '.' before 'f'\n"
        "x = 1f + '' + \"\\q\" )\n"
        "    ^\n"
        "test.ops:1:10: error: [OPS007] found '', expected one letter of one byte; put texts into double quotes\n"
        "x = 1f + '' + \"\\q\" )\n"
        "         ^\n"
        "test.ops:1:16: error: [OPS007] found '\\q', expected an escape such as '\\n', or '\\\\' for a backslash\n"
        "x = 1f + '' + \"\\q\" )\n"
        "               ^\n"
        "test.ops:1:20: error: [OPS002] found ')', expected a new line or ';' at the end of the statement\n"
        "x = 1f + '' + \"\\q\" )\n"
        "                   ^\n");
}

}  // namespace
