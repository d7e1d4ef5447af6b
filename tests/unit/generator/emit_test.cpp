// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <emit/depfile.hpp>
#include <emit/outputs.hpp>

#include <sstream>

#include <gtest/gtest.h>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;

namespace oroforge::emit {
namespace {

using test::readFile;
using test::TempDir;

TEST(Write, MakesDirectoriesAndFiles) {
    const TempDir dir;
    diag::Sink sink;

    ASSERT_TRUE(write({{"a/b/c.txt", "one"}, {"d.txt", "two"}}, dir / "new", sink));

    EXPECT_EQ(readFile(dir / "new/a/b/c.txt"), "one");
    EXPECT_EQ(readFile(dir / "new/d.txt"), "two");
}

TEST(Write, LeavesUnchangedFilesAlone) {
    const TempDir dir;
    diag::Sink sink;
    dir.write("same.txt", "one");
    dir.write("other.txt", "old");
    const auto old = fs::last_write_time(dir / "same.txt") - std::chrono::hours(1);
    fs::last_write_time(dir / "same.txt", old);
    Written written;

    ASSERT_TRUE(write({{"same.txt", "one"}, {"other.txt", "new"}}, dir.path(), sink, &written));

    EXPECT_EQ(fs::last_write_time(dir / "same.txt"), old);
    EXPECT_EQ(written.unchanged, std::vector<std::string>{"same.txt"});
    EXPECT_EQ(written.changed, std::vector<std::string>{"other.txt"});
}

TEST(Write, WritesAllOrNothing) {
    const TempDir dir;
    diag::Sink sink;
    dir.write("a.txt", "old");
    fs::create_directories(dir / "z.txt");  // in the way of a file
    const auto before = test::readTree(dir.path());

    EXPECT_FALSE(write({{"a.txt", "new"}, {"sub/b.txt", "new"}, {"z.txt", "new"}}, dir.path(), sink));

    EXPECT_EQ(test::readTree(dir.path()), before);
    EXPECT_FALSE(fs::exists(dir / "sub"));
    ASSERT_EQ(sink.errorCount(), 1U);
    EXPECT_EQ(sink.all()[0].message, "found a directory, expected a file or nothing");
}

TEST(Write, FileInPlaceOfADirectoryIsReported) {
    const TempDir dir;
    diag::Sink sink;
    dir.write("a", "file");

    EXPECT_FALSE(write({{"a/b.txt", "x"}}, dir.path(), sink));
    EXPECT_EQ(sink.all()[0].code, "EMIT001");
}

TEST(Write, LeavesNoTemporaryFiles) {
    const TempDir dir;
    diag::Sink sink;
    dir.write("a.txt", "old");

    ASSERT_TRUE(write({{"a.txt", "new"}, {"b.txt", "new"}}, dir.path(), sink));

    EXPECT_EQ(test::readTree(dir.path()).size(), 2U);
}

TEST(ListOutputs, PrintsOnePathPerLine) {
    std::ostringstream out;

    listOutputs(out, Outputs{{"b", ""}, {"a", ""}}, "dir");

    EXPECT_EQ(out.str(), "dir/a\ndir/b\n");
}

TEST(Depfile, EscapesWhatMakeWouldRead) {
    EXPECT_EQ(depfileText({"a b", "c"}, {"d$e", "f#"}), "a\\ b c: \\\n  d$$e \\\n  f\\#\n");
}

}  // namespace
}  // namespace oroforge::emit
