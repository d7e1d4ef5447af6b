// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <flags/flags_file.hpp>

#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge;
using flags::meaningfulFlags;
using oroforge::test::TempDir;
using Words = std::vector<std::string>;

TEST(MeaningfulFlags, KeepsFoldersAndMacrosOnly) {
    EXPECT_EQ(meaningfulFlags({"-O2", "-Ia", "-isystem", "b", "-Wall", "-DX=1", "-UY", "-includec.hpp", "-fPIC"}),
              (Words{"-I", "a", "-isystem", "b", "-D", "X=1", "-U", "Y", "-include", "c.hpp"}));
}

TEST(MeaningfulFlags, KeepsStandardsThatTheBuildDoesNotRaise) {
    EXPECT_EQ(meaningfulFlags({"-std=c++11", "-std=gnu++14", "-std=c++0x", "-std=gnu++17", "-std=c++20"}),
              (Words{"-std=gnu++17", "-std=c++20"}));
}

TEST(MeaningfulFlags, DropsOptionsThatLostTheirValue) {
    EXPECT_EQ(meaningfulFlags({"-D", "-I", "", "-DX"}), (Words{"-D", "X"}));
}

TEST(MeaningfulFlags, SplitsSeveralWordsInOne) {
    EXPECT_EQ(meaningfulFlags({"SHELL:-include a.hpp -DX"}), (Words{"-include", "a.hpp", "-D", "X"}));
}

TEST(ReadFlagsFile, TakesEachLineForAWord) {
    const TempDir dir;
    diag::Sink sink;
    EXPECT_EQ(flags::readFlagsFile(dir.write("f", "-DTEXT=\"a b\"\n\n-Iwith blank\n").string(), sink),
              (Words{"-D", "TEXT=\"a b\"", "-I", "with blank"}));
    EXPECT_TRUE(sink.empty());
}

TEST(ReadFlagsFile, ReportsAMissingFile) {
    diag::Sink sink;
    EXPECT_TRUE(flags::readFlagsFile("/no/such/file", sink).empty());
    ASSERT_EQ(sink.errorCount(), 1U);
    EXPECT_EQ(sink.all()[0].code, "TK008");
}
