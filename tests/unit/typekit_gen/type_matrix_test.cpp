// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// tests/golden/matrix.txt: every case of the type matrix is shown by a golden.
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <support/golden.hpp>

namespace fs = std::filesystem;
using namespace oroforge::test;

namespace {

constexpr int kCases = 95;
constexpr int kFewestSupported = 50;

struct Case {
    char kind = '?';
    std::vector<std::string> goldens;
};

std::map<int, Case> readMatrix() {
    std::map<int, Case> all;
    std::ifstream file(sourceRoot() / "tests/golden/matrix.txt");
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        int number = 0;
        Case one;
        words >> number >> one.kind;
        for (std::string golden; words >> golden;) one.goldens.push_back(golden);
        EXPECT_TRUE(all.emplace(number, one).second) << "case " << number << " twice";
    }
    return all;
}

}  // namespace

TEST(TypeMatrix, EveryCaseHasItsGoldens) {
    const auto all = readMatrix();
    for (int number = 1; number <= kCases; ++number) {
        const auto found = all.find(number);
        ASSERT_NE(found, all.end()) << "case " << number;
        EXPECT_FALSE(found->second.goldens.empty()) << "case " << number;
        for (const std::string& golden : found->second.goldens)
            EXPECT_TRUE(fs::exists(sourceRoot() / "tests/golden" / golden / "expected")) << number << ": " << golden;
    }
    EXPECT_EQ(all.size(), std::size_t(kCases));
}

// What is supported is compiled, loaded and given values; what is refused is shown to be refused.
TEST(TypeMatrix, GoldensAreOfTheRightKind) {
    int supported = 0;
    for (const auto& [number, one] : readMatrix()) {
        supported += one.kind == 'S' ? 1 : 0;
        const std::string wanted = one.kind == 'S' ? "typekit" : one.kind == 'E' ? "diagnostics_types/" : "remarks/";
        bool any = false;
        for (const std::string& golden : one.goldens) any = any || golden.compare(0, wanted.size(), wanted) == 0;
        // Which options and which header were given shows in the model already.
        any = any || number == 85 || number == 86;
        EXPECT_TRUE(any) << "case " << number << " has no golden in " << wanted;
    }
    EXPECT_GE(supported, kFewestSupported);
}
