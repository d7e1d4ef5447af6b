// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// --format and --explain of typegen, as its user calls it.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <driver/typegen.hpp>
#include <nlohmann/json.hpp>
#include <support/run_typegen.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge::test;
using nlohmann::json;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(TypegenFormat, DocumentsStandAloneOnStandardOutput) {
    const TempDir dir;
    const std::string bad = dir.write("bad.hpp", "#pragma once\nstruct A { int* p; };\n").string();
    for (const char* format : {"--format=json", "--format=sarif"}) {
        const Ran ran = runTypegen({format, "-v", "-o", (dir / "out").string(), "demo", bad});
        EXPECT_EQ(ran.status, 1);
        EXPECT_EQ(ran.err, "");
        EXPECT_TRUE(contains(json::parse(ran.out).dump(), "TK010"));
    }
    EXPECT_FALSE(std::filesystem::exists(dir / "out"));
}

TEST(TypegenFormat, SuccessIsADocumentTooAndVerboseTextGoesAside) {
    const TempDir dir;
    const std::string good = dir.write("good.hpp", "#pragma once\nstruct A { int x; };\n").string();
    const Ran ran = runTypegen({"--format", "json", "-v", "-o", (dir / "out").string(), "demo", good});
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(json::parse(ran.out)["diagnostics"], json::array());
    EXPECT_TRUE(contains(ran.err, "struct /A")) << ran.err;
}

TEST(TypegenFormat, AWrongCommandLineIsReportedInTheFormatItAsksFor) {
    const Ran ran = runTypegen({"--format=json", "--nonsense", "demo", "x.hpp"});
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(json::parse(ran.out)["diagnostics"][0]["code"], "TK003");
    const Ran unknown = runTypegen({"--format=xml", "demo", "x.hpp"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_EQ(unknown.err,
              "typegen: error: [TK003] unknown value 'xml' of --format, expected 'text', 'json' or 'sarif'\n");
}

TEST(TypegenFormat, ExcludesWhatElseWritesToStandardOutput) {
    for (const char* other : {"--dump=model", "--list-outputs"}) {
        const Ran ran = runTypegen({"--format=sarif", other, "demo", "x.hpp"});
        EXPECT_EQ(ran.status, 1);
        EXPECT_TRUE(contains(json::parse(ran.out).dump(), "TK003"));
    }
}

TEST(TypegenFormat, HelpIsNoReport) {
    EXPECT_EQ(runTypegen({"--format=json", "--help"}).out.compare(0, 14, "usage: typegen"), 0);
    EXPECT_EQ(runTypegen({"--format=json", "--help"}).out.find("diagnostics\""), std::string::npos);
}

TEST(TypegenFormat, AMissingValueIsOneError) {
    EXPECT_EQ(runTypegen({"demo", "x.hpp", "--format"}).err,
              "typegen: error: [TK003] option '--format' needs a value\n");
    EXPECT_EQ(runTypegen({"demo", "x.hpp", "-t"}).err.find("unknown transport"), std::string::npos);
}

TEST(TypegenFormat, OutputThatCannotBeWrittenIsAFailure) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"--help"}, {"--explain"}, {"--list-outputs", "demo", "x.hpp"}}) {
        std::ofstream full("/dev/full");
        std::ostringstream err;
        EXPECT_EQ(oroforge::typekit::run(words, full, err), 1);
        EXPECT_EQ(err.str(), "typegen: error: [EMIT004] cannot write to standard output: No space left on device\n");
    }
}

TEST(TypegenFormat, TextIsTheDefault) {
    const TempDir dir;
    const Ran ran = runTypegen({"--format=text", "demo", (dir / "absent.hpp").string()});
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(contains(ran.err, "[TK001]"));
}

TEST(TypegenExplain, PrintsWhatACodeMeans) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"--explain", "TK014"}, {"--explain=TK014"}, {"--explain", "tk014"}}) {
        const Ran ran = runTypegen(words);
        EXPECT_EQ(ran.status, 0);
        EXPECT_EQ(ran.err, "");
        EXPECT_EQ(ran.out.compare(0, 14, "TK014: a union"), 0) << ran.out;
    }
    EXPECT_TRUE(contains(runTypegen({"--explain", "TK014", "TK010"}).out, "\n\nTK010: a raw pointer\n\n"));
}

TEST(TypegenExplain, AloneListsAllCodes) {
    const Ran ran = runTypegen({"--explain"});
    EXPECT_EQ(ran.status, 0);
    EXPECT_TRUE(contains(ran.out, "TK014  a union\n")) << ran.out;
}

TEST(TypegenExplain, UnknownCodesAreErrorsWithTheNearest) {
    const Ran ran = runTypegen({"--explain", "TKO14"});
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err,
              "typegen: error: [TK003] no diagnostic has the code 'TKO14'; did you mean 'TK014'?\n"
              "note: typegen --explain lists all codes\n");
}
