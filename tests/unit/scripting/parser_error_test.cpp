// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// All that is said about each script of syntax_errors.txt. A case there is a line "=== Name", a script, a line "---" and what is
/// printed. UPDATE_GOLDENS=1 <program> --gtest_filter=SyntaxErrors.* writes the file anew.
#include "ast_text.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <ostream>
#include <sstream>
#include <vector>

namespace {

struct Case {
    std::string name, script, expected;
};

std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.name; }

std::vector<Case> readCases() {
    std::ifstream in(SYNTAX_ERRORS_FILE);
    std::vector<Case> cases;
    bool expected = false;
    for (std::string line; std::getline(in, line);) {
        if (line.compare(0, 4, "=== ") == 0) {
            cases.push_back({line.substr(4), "", ""});
            expected = false;
        } else if (line == "---") {
            expected = true;
        } else if (!cases.empty()) {
            (expected ? cases.back().expected : cases.back().script) += line + "\n";
        }
    }
    return cases;
}

void writeCases(const std::vector<Case>& cases) {
    std::ofstream out(SYNTAX_ERRORS_FILE);
    for (const Case& one : cases)
        out << "=== " << one.name << '\n' << one.script << "---\n" << tests::complaints(one.script);
}

class SyntaxError : public ::testing::TestWithParam<Case> {};

TEST_P(SyntaxError, IsToldWithItsPlaceAndWithoutNoise) {
    EXPECT_EQ(tests::complaints(GetParam().script), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Script, SyntaxError, ::testing::ValuesIn(readCases()),
                         [](const ::testing::TestParamInfo<Case>& info) { return info.param.name; });

TEST(SyntaxErrors, CasesAreThere) {
    const std::vector<Case> cases = readCases();
    EXPECT_GT(cases.size(), 40u);
    if (std::getenv("UPDATE_GOLDENS")) writeCases(cases);
}

}  // namespace
