// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <emit/depfile.hpp>
#include <emit/outputs.hpp>

#include <algorithm>
#include <sstream>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// The number of a process that has ended.
pid_t deadProcess() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

TEST(Write, DoesNotFollowLinksThatWerePlanted) {
    const TempDir dir;
    diag::Sink sink;
    const fs::path victim = dir.write("victim", "mine");
    fs::create_directory(dir / "out");
    const std::string target = (dir / "out/a.txt").string(), process = std::to_string(::getpid());
    fs::create_symlink(victim, target + ".new" + process);
    for (int i = 0; i != 60; ++i) {
        const std::string name = target + "." + process + "." + std::to_string(i);
        fs::create_symlink(victim, name + ".new");
        fs::create_symlink(victim, name + ".old");
    }
    const auto planted = test::readTree(dir / "out").size();

    for (const char* text : {"one", "two"}) ASSERT_TRUE(write({{"a.txt", text}}, dir / "out", sink));

    EXPECT_EQ(readFile(victim), "mine");
    EXPECT_EQ(readFile(target), "two");
    EXPECT_EQ(test::readTree(dir / "out").size(), planted + 1) << "links of others were removed, or drafts stay";
}

TEST(Write, ReplacesALinkAndKeepsWhatItLedTo) {
    const TempDir dir;
    diag::Sink sink;
    const fs::path victim = dir.write("victim", "mine");
    fs::create_symlink(victim, dir / "a.txt");

    ASSERT_TRUE(write({{"a.txt", "new"}}, dir.path(), sink));

    EXPECT_EQ(readFile(victim), "mine");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(dir / "a.txt")));
}

TEST(Write, RemovesWhatDeadProcessesLeft) {
    const TempDir dir;
    diag::Sink sink;
    const std::string dead = std::to_string(deadProcess()), alive = std::to_string(::getppid());
    for (const char* name : {"same.txt", "sub/a.txt"}) {
        dir.write(name + ("." + dead) + ".0.new", "half");
        dir.write(name + ("." + dead) + ".1.old", "old");
        dir.write(name + ("." + alive) + ".0.new", "of somebody at work");
    }
    dir.write("same.txt", "same");
    dir.write("mine.txt." + dead + ".0.new", "about another file");
    dir.write("same.txt." + dead + ".new", "of another form");

    ASSERT_TRUE(write({{"same.txt", "same"}, {"sub/a.txt", "new"}}, dir.path(), sink));

    EXPECT_EQ(test::readTree(dir.path()).size(), 6U);
    EXPECT_FALSE(fs::exists(dir / ("same.txt." + dead + ".0.new")));
    EXPECT_FALSE(fs::exists(dir / ("sub/a.txt." + dead + ".1.old")));
}

TEST(Write, KeepsThePermissionsOfAFile) {
    const TempDir dir;
    diag::Sink sink;
    const auto mode = fs::perms::owner_all | fs::perms::group_read;
    fs::permissions(dir.write("a.sh", "old"), mode);

    ASSERT_TRUE(write({{"a.sh", "new"}}, dir.path(), sink));

    EXPECT_EQ(fs::status(dir / "a.sh").permissions(), mode);
}

TEST(Write, DevicesAreWrittenToAndTheReasonIsTold) {
    const TempDir dir;
    diag::Sink sink;
    fs::create_symlink("/dev/full", dir / "full");
    fs::create_symlink("/dev/null", dir / "null");
    dir.write("a.txt", "old");

    EXPECT_TRUE(write({{"null", "new"}}, dir.path(), sink));
    EXPECT_FALSE(write({{"a.txt", "new"}, {"full", "new"}}, dir.path(), sink));

    EXPECT_TRUE(fs::is_symlink(dir / "null"));
    EXPECT_TRUE(fs::is_symlink(dir / "full"));
    EXPECT_EQ(readFile(dir / "a.txt"), "old");
    ASSERT_EQ(sink.errorCount(), 1U);
    EXPECT_EQ(sink.all()[0].code, "EMIT001");
    EXPECT_EQ(sink.all()[0].message, "cannot write the file: No space left on device");
}

TEST(Write, TellsThatAFolderMayNotBeWrittenTo) {
    const TempDir dir;
    ASSERT_EQ(::chmod(dir.path().c_str(), 0555), 0);
    int told[2] = {-1, -1};
    ASSERT_EQ(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        if (::geteuid() == 0 && ::setuid(54321) != 0) ::_exit(1);
        diag::Sink sink;
        const bool written = write({{"a.txt", "new"}}, dir.path(), sink);
        const std::string text = written || sink.empty() ? "written" : sink.all()[0].message;
        ::_exit(::write(told[1], text.data(), text.size()) < 0 ? 2 : 0);
    }
    ::close(told[1]);
    std::string text(200, '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::read(told[0], text.data(), text.size()))));
    ::close(told[0]);
    ::waitpid(child, nullptr, 0);

    EXPECT_EQ(text, "cannot write the file: Permission denied");
}

TEST(Write, ANameThatIsTooLongIsReported) {
    const TempDir dir;
    diag::Sink sink;

    EXPECT_FALSE(write({{std::string(300, 'x') + "/a.txt", "new"}}, dir.path(), sink));

    ASSERT_EQ(sink.errorCount(), 1U);
    EXPECT_EQ(sink.all()[0].message, "cannot make the directory: File name too long");
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
