// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <collect/header_inputs.hpp>

#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge;
using oroforge::test::TempDir;
using typekit::includeSpelling;

TEST(IncludeDirsOf, TakesBothFormsOfBothOptions) {
    EXPECT_EQ(typekit::includeDirsOf({"-I", "a", "-Ib", "-isystem", "c", "-DX", "-I"}),
              (std::vector<std::string>{"a", "b", "c"}));
}

TEST(IncludeSpelling, IsRelativeToTheIncludeFolder) {
    const TempDir dir;
    const auto header = dir.write("src/part/types.hpp", "").string();
    EXPECT_EQ(includeSpelling(header, {(dir / "src").string()}, "pkg"), "part/types.hpp");
}

TEST(IncludeSpelling, PrefersTheFolderNamedAfterThePackage) {
    const TempDir dir;
    const auto header = dir.write("include/pkg/types.hpp", "").string();
    const std::string deep = (dir / "include/pkg").string();
    EXPECT_EQ(includeSpelling(header, {deep, (dir / "include").string()}, "pkg"), "pkg/types.hpp");
    EXPECT_EQ(includeSpelling(header, {deep}, "pkg"), "pkg/types.hpp");
    EXPECT_EQ(includeSpelling(header, {}, "pkg"), "pkg/types.hpp");
    EXPECT_EQ(includeSpelling(header, {}, "another"), "pkg/types.hpp");
}

TEST(IncludeSpelling, IsNeverAbsolute) {
    const TempDir dir;
    EXPECT_EQ(includeSpelling(dir.write("types.hpp", "").string(), {}, "pkg"), "types.hpp");
}

TEST(IncludeSpelling, FollowsSymbolicLinksOfTheIncludeFolder) {
    const TempDir dir;
    const auto header = dir.write("real/types.hpp", "").string();
    std::filesystem::create_directory_symlink(dir / "real", dir / "link");
    EXPECT_EQ(includeSpelling(header, {(dir / "link").string()}, "pkg"), "types.hpp");
}

TEST(ExpandInputs, SearchesFoldersSorted) {
    const TempDir dir;
    for (const char* name : {"b.hpp", "a.h", "sub/c.hh", "text.txt", "MyTypekit.hpp"}) dir.write(name, "");
    diag::Sink sink;
    const std::string root = dir.path().string();
    EXPECT_EQ(typekit::expandInputs({root}, sink),
              (std::vector<std::string>{root + "/a.h", root + "/b.hpp", root + "/sub/c.hh"}));
    EXPECT_TRUE(sink.empty());
}

TEST(ExpandInputs, LeavesHiddenFoldersAndBuildTreesOut) {
    const TempDir dir;
    for (const char* name : {"a.h", ".git/b.h", "build/CMakeCache.txt", "build/types/c.h", "sub/.old/d.h", "sub/e.h"})
        dir.write(name, "");
    diag::Sink sink;
    const std::string root = dir.path().string();
    EXPECT_EQ(typekit::expandInputs({root}, sink), (std::vector<std::string>{root + "/a.h", root + "/sub/e.h"}));
    EXPECT_EQ(typekit::expandInputs({root + "/build"}, sink), std::vector<std::string>{root + "/build/types/c.h"});
    EXPECT_TRUE(sink.empty());
}

TEST(ExpandInputs, ReportsEveryInputThatIsMissing) {
    const TempDir dir;
    diag::Sink sink;
    typekit::expandInputs({"absent_1.hpp", dir.path().string(), "absent_2.hpp"}, sink);
    ASSERT_EQ(sink.errorCount(), 3U);
    EXPECT_EQ(sink.all()[0].code, "TK001");
    EXPECT_EQ(sink.all()[1].code, "TK002");
}
