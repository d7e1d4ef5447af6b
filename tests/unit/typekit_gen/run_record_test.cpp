// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// typegen does nothing when there is nothing to do, and only then.
#include <driver/typegen.hpp>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <support/golden.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace oroforge::test;

namespace {

class RunRecordTest : public testing::Test {
protected:
    RunRecordTest() {
        ::setenv("TYPEGEN_CACHE", (dir / "cache").c_str(), 1);
        write("inner.hpp", "#pragma once\nstruct Inner { int x; };\n");
        write("types.hpp", "#pragma once\n#include \"inner.hpp\"\nstruct A { Inner inner; };\n");
    }
    ~RunRecordTest() override { ::unsetenv("TYPEGEN_CACHE"); }

    /// As if it had been written a while ago.
    fs::path write(const std::string& name, const std::string& text) {
        const fs::path file = dir.write(name, text);
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(++writes_));
        return file;
    }
    /// Whether there was nothing to do.
    bool upToDate(const std::vector<std::string>& more = {}) {
        std::vector<std::string> words = {"-v", "-o", (dir / "out").string(), "demo", (dir / "types.hpp").string()};
        words.insert(words.end(), more.begin(), more.end());
        std::ostringstream out, err;
        EXPECT_EQ(oroforge::typekit::run(words, out, err), 0) << err.str();
        return out.str() == "up to date\n";
    }

    const TempDir dir;

private:
    int writes_ = 0;
};

}  // namespace

TEST_F(RunRecordTest, TheSecondRunHasNothingToDo) {
    EXPECT_FALSE(upToDate());
    const auto tree = readTree(dir / "out");
    EXPECT_TRUE(upToDate());
    EXPECT_EQ(readTree(dir / "out"), tree) << "no record among the outputs";
}

TEST_F(RunRecordTest, ChangedInputsAreRead) {
    EXPECT_FALSE(upToDate());
    write("inner.hpp", "#pragma once\nstruct Inner { int x, y; };\n");
    EXPECT_FALSE(upToDate());
    EXPECT_TRUE(upToDate());
    write("types.hpp", "#pragma once\n#include \"inner.hpp\"\nstruct B { Inner inner; };\n");
    EXPECT_FALSE(upToDate());
}

TEST_F(RunRecordTest, ChangedAdaptersAreRead) {
    const std::string begin = "<adapters><struct class=\"Inner\"><member name=\"",
                      end = "\" get=\"x\"/></struct></adapters>";
    const std::string option = "--adapters=" + write("a.xml", begin + "a" + end).string();
    EXPECT_FALSE(upToDate({option}));
    EXPECT_TRUE(upToDate({option}));
    write("a.xml", begin + "b" + end);
    EXPECT_FALSE(upToDate({option}));
    EXPECT_FALSE(upToDate());
}

TEST_F(RunRecordTest, WhatIsWrittenDuringARunIsReadAgain) {
    const fs::path file = write("inner.hpp", "#pragma once\nstruct Inner { int z; };\n");
    fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::minutes(1));  // later than the runs begin
    EXPECT_FALSE(upToDate());
    EXPECT_FALSE(upToDate());
}

TEST_F(RunRecordTest, ChangedOutputsAreWrittenAgain) {
    EXPECT_FALSE(upToDate());
    const auto tree = readTree(dir / "out");
    fs::remove(dir / "out" / "types_types.cpp");
    EXPECT_FALSE(upToDate());
    dir.write("out/types_types.cpp", tree.at("types_types.cpp") + "// edited\n");
    EXPECT_FALSE(upToDate());
    EXPECT_EQ(readTree(dir / "out"), tree);
}

TEST_F(RunRecordTest, OtherOptionsAreAnotherRun) {
    EXPECT_FALSE(upToDate());
    EXPECT_FALSE(upToDate({"-DMORE"}));
    EXPECT_TRUE(upToDate({"-DMORE"}));
    EXPECT_FALSE(upToDate());
}

TEST_F(RunRecordTest, WarningsAreToldEachTime) {
    write("types.hpp", "#pragma once\n#include \"inner.hpp\"\n");
    for (int run = 0; run != 2; ++run) {
        std::ostringstream out, err;
        oroforge::typekit::run({"-o", (dir / "out").string(), "demo", (dir / "types.hpp").string()}, out, err);
        EXPECT_NE(err.str().find("TK061"), std::string::npos) << run;
    }
}

TEST_F(RunRecordTest, CanBeTurnedOff) {
    ::setenv("TYPEGEN_CACHE", "", 1);
    EXPECT_FALSE(upToDate());
    EXPECT_FALSE(upToDate());
    EXPECT_FALSE(fs::exists(dir / "cache"));
}
