// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Whole runs of typegen against tests/golden/{model,typekit,diagnostics_types,remarks}. A case is a folder with its headers;
// the file `args`, one word on each line, holds the command line.
#include <sstream>

#include <support/golden.hpp>
#include <support/run_typegen.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;
using namespace oroforge::test;

namespace {

class Model : public testing::TestWithParam<std::string> {};
class Typekit : public testing::TestWithParam<std::string> {};
class Remarks : public testing::TestWithParam<std::string> {};
class TypeDiagnostics : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(Model, IsReadFromHeaders) {
    const fs::path dir = goldenDir("model", GetParam());
    const Ran ran = runTypegenIn(dir, {"--dump=model"});
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err, "");
    expectGolden(dir / "expected/model.json", ran.out);
}

TEST_P(Typekit, IsGenerated) {
    const fs::path dir = goldenDir("typekit", GetParam());
    const TempDir output;
    const Ran ran = runTypegenIn(dir, {"-o", output.path().string()});
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(ran.out, "");
    expectGoldenTree(dir / "expected", readTree(output.path()));
}

TEST_P(TypeDiagnostics, AreLocatedAndNothingIsWritten) {
    const fs::path dir = goldenDir("diagnostics_types", GetParam());
    const TempDir place;
    const fs::path output = place / "output";
    const Ran ran = runTypegenIn(dir, {"-o", output.string(), "--depfile", (place / "depfile").string()});
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_FALSE(fs::exists(output));
    EXPECT_FALSE(fs::exists(place / "depfile"));
    expectGolden(dir / "expected/stderr.txt", ran.err);
}

/// What is said of headers that are fine: warnings, and what --verbose adds.
TEST_P(Remarks, AreLocated) {
    const fs::path dir = goldenDir("remarks", GetParam());
    const TempDir output;
    const Ran ran = runTypegenIn(dir, {"-v", "-o", output.path().string()});
    EXPECT_EQ(ran.status, 0);
    expectGolden(dir / "expected/stderr.txt", ran.err);
    std::string notes;
    std::istringstream lines(ran.out);
    for (std::string line; std::getline(lines, line);)
        if (line.find(": note: ") != std::string::npos) notes += line + "\n";
    expectGolden(dir / "expected/notes.txt", notes);
}

INSTANTIATE_TEST_SUITE_P(Golden, Remarks, testing::ValuesIn(goldenCases("remarks")), caseName);
INSTANTIATE_TEST_SUITE_P(Golden, Model, testing::ValuesIn(goldenCases("model")), caseName);
INSTANTIATE_TEST_SUITE_P(Golden, Typekit, testing::ValuesIn(goldenCases("typekit")), caseName);
INSTANTIATE_TEST_SUITE_P(Golden, TypeDiagnostics, testing::ValuesIn(goldenCases("diagnostics_types")), caseName);
