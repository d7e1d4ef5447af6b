// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What is too deep is an error; what is only long is not.
#include "ast_text.hpp"

#include <rtt/scripting/detail/syntax/parser.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

namespace {

using namespace RTT::scripting::detail;  // NOLINT: the parser is the subject
using tests::complaints;

constexpr unsigned kMost = kMaxNesting;

std::string repeated(const std::string& text, std::size_t times) {
    std::string result;
    for (std::size_t i = 0; i < times; ++i) result += text;
    return result;
}

std::size_t errorsIn(const std::string& script) {
    oroforge::diag::Sink sink;
    parse(script, "test.ops", sink);
    return sink.errorCount();
}

std::string tooDeep(unsigned line, unsigned column) {
    return "test.ops:" + std::to_string(line) + ":" + std::to_string(column) +
           ": error: [OPS010] found expressions or blocks in each other more than 200 deep\n";
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n') + 1); }

TEST(ScriptLimits, ParenthesesNest) {
    const auto nested = [](std::size_t n) { return repeated("(", n) + "a" + repeated(")", n); };
    EXPECT_EQ(complaints(nested(kMost - 1)), "");
    EXPECT_EQ(firstLine(complaints(nested(kMost))), tooDeep(1, kMost + 1));
    EXPECT_EQ(errorsIn(nested(20000) + "\nb c"), 2u);
}

TEST(ScriptLimits, CallsIndicesAndAssignmentsNest) {
    EXPECT_EQ(complaints(repeated("f(", kMost - 1) + "a" + repeated(")", kMost - 1)), "");
    EXPECT_EQ(errorsIn(repeated("f(", kMost) + "a" + repeated(")", kMost)), 1u);
    EXPECT_EQ(complaints(repeated("f[", kMost - 1) + "a" + repeated("]", kMost - 1)), "");
    EXPECT_EQ(errorsIn(repeated("f[", kMost) + "a" + repeated("]", kMost)), 1u);
    EXPECT_EQ(complaints(repeated("f = ", kMost - 1) + "a"), "");
    EXPECT_EQ(errorsIn(repeated("f = ", kMost) + "a"), 1u);
}

/// Members and elements in a row nest to the left, although nothing is open while they are read.
TEST(ScriptLimits, MembersAndElementsInARowNest) {
    EXPECT_EQ(complaints("a" + repeated("[0]", kMost)), "");
    EXPECT_EQ(errorsIn("a" + repeated("[0]", kMost + 1)), 1u);
    EXPECT_EQ(errorsIn("f()" + repeated(".a", kMost + 1)), 1u);
}

/// As scripts that were generated have them.
TEST(ScriptLimits, OperatorsInARowDoNotNest) {
    EXPECT_EQ(errorsIn("a" + repeated(" + a", 5000)), 0u);
    EXPECT_EQ(errorsIn("a" + repeated(" * a + a", 20000)), 0u);
    EXPECT_EQ(errorsIn("f(" + repeated("b + ", 5000) + "a)"), 0u);
    EXPECT_EQ(errorsIn(repeated("a + (", 150) + "a" + repeated(" - a", 5000) + repeated(")", 150)), 0u);
    EXPECT_EQ(errorsIn("a" + repeated("+a", 100000)), 0u);
}

TEST(ScriptLimits, OperatorsInARowAreLimited) {
    const std::string error = complaints("a" + repeated("+a", 100001));
    EXPECT_EQ(firstLine(error), "test.ops:1:200002: error: [OPS010] found more than 100000 operators in a row\n");
    EXPECT_EQ(errorsIn("a" + repeated("+a", 150000) + "\nb c"), 2u);
}

TEST(ScriptLimits, PathsMayBeLong) { EXPECT_EQ(complaints("a" + repeated(".a", 10000)), ""); }

TEST(ScriptLimits, BlocksNest) {
    const auto nested = [](std::size_t n) { return repeated("if a then {\n", n) + repeated("}\n", n); };
    EXPECT_EQ(complaints(nested(kMost - 1)), "");
    EXPECT_EQ(firstLine(complaints(nested(kMost + 1))), tooDeep(kMost + 1, 4));
    EXPECT_EQ(errorsIn(nested(kMost + 1)), 1u);
    EXPECT_EQ(errorsIn(nested(20000) + "\nb c"), 2u);
    EXPECT_EQ(errorsIn(repeated("if a then ", 20000) + "\nb c"), 2u);
    EXPECT_EQ(errorsIn(repeated("while a {", 20000)), 2u);  // and a '}' is missing
}

TEST(ScriptLimits, ManyErrorsAreToldOnceEach) {
    EXPECT_EQ(errorsIn(repeated("a b\n", 5000)), 5000u);
    EXPECT_EQ(errorsIn(repeated("}\n", 5000)), 5000u);
    EXPECT_EQ(errorsIn(repeated("foo(1\n", 5000)), 5000u);
    EXPECT_EQ(errorsIn(repeated("program p {\n", 5000)), 5000u);
}

/// Twenty times as long a script may take twenty times as long; a hundred is far from the 400 of quadratic growth.
TEST(ScriptLimits, TimeGrowsWithTheLength) {
    for (const char* piece : {"x = y * 1.5 + z\n", "a b\n", "f(\n", "a<", "(", "{", "/*", "\"", "if ", "a.",
                              "program p {\n", "StateMachine T { state S { ", "x = f(1, [\n", "; } else ", "const "}) {
        const auto seconds = [&](std::size_t times) {
            const std::string script = repeated(piece, times);
            double best = 1e9;
            for (int i = 0; i < 2; ++i) {
                const std::clock_t begin = std::clock();
                errorsIn(script);
                best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
            }
            return best;
        };
        const double few = std::max(seconds(500), 1e-4);
        EXPECT_LT(seconds(10000) / few, 100) << piece;
    }
}

}  // namespace
