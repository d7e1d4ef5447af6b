// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <collect/import_package.hpp>

#include <cstdlib>

#include <flags/flags_file.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge;
using oroforge::test::TempDir;

TEST(SplitFlags, HonoursBackslashes) {
    EXPECT_EQ(flags::splitFlags("-I/a/b -I/with\\ blank  -I/c\n"),
              (std::vector<std::string>{"-I/a/b", "-I/with blank", "-I/c"}));
    EXPECT_TRUE(flags::splitFlags(" \n").empty());
}

TEST(ImportFlags, AsksForTheTypekitFirst) {
    const TempDir dir;
    dir.write("there-typekit-gnulinux.pc", "Name: a\nDescription: b\nVersion: 1\nCflags: -I/of/typekit\n");
    dir.write("there.pc", "Name: a\nDescription: b\nVersion: 1\nCflags: -I/of/package\n");
    ::setenv("PKG_CONFIG_PATH", dir.path().c_str(), 1);
    diag::Sink sink;
    EXPECT_EQ(typekit::importFlags("there", "gnulinux", sink), (std::vector<std::string>{"-I/of/typekit"}));
    EXPECT_EQ(typekit::importFlags("there", "xenomai", sink), (std::vector<std::string>{"-I/of/package"}));
    EXPECT_TRUE(sink.empty());
}

TEST(ImportFlags, UnknownPackageIsAnErrorAndNothingIsExecuted) {
    const TempDir dir;
    diag::Sink sink;
    EXPECT_TRUE(typekit::importFlags("absent", "gnulinux", sink).empty());
    EXPECT_TRUE(typekit::importFlags("x; touch " + (dir / "trace").string(), "gnulinux", sink).empty());
    ASSERT_EQ(sink.errorCount(), 2U);
    EXPECT_EQ(sink.all()[0].code, "TK004");
    EXPECT_FALSE(std::filesystem::exists(dir / "trace"));
}
