// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <console/history.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace {

using OCL::console::History;
using oroforge::test::readFile;
using oroforge::test::TempDir;
using testing::ElementsAre;

TEST(History, IsKeptInAFileLineByLine) {
    const TempDir directory;
    const std::string file = directory / "history";
    {
        History history(file);
        EXPECT_TRUE(history.add("one"));
        EXPECT_TRUE(history.add("two"));
        EXPECT_EQ("one\ntwo\n", readFile(file));  // at once, not at its end
    }
    History later(file);
    EXPECT_THAT(later.lines(), ElementsAre("one", "two"));
    later.add("three");
    EXPECT_EQ("one\ntwo\nthree\n", readFile(file));
}

TEST(History, LeavesOutRepeatsBlanksAndQuit) {
    History history;
    EXPECT_TRUE(history.add("ls"));
    EXPECT_FALSE(history.add("ls"));
    EXPECT_FALSE(history.add("  "));
    EXPECT_FALSE(history.add("quit"));
    EXPECT_TRUE(history.add("cd x"));
    EXPECT_TRUE(history.add("ls"));
    EXPECT_THAT(history.lines(), ElementsAre("ls", "cd x", "ls"));
}

TEST(History, AnUnreadableFileIsNoHistory) {
    History history("/nowhere/at/all");
    EXPECT_EQ("/nowhere/at/all: what is typed is not kept: No such file or directory", history.problem());
    EXPECT_TRUE(history.lines().empty());
    EXPECT_TRUE(history.add("one"));
    EXPECT_THAT(history.lines(), ElementsAre("one"));
}

TEST(History, AFileThatCanBeWrittenIsNoProblem) {
    const TempDir directory;
    EXPECT_EQ("", History(directory / "new").problem());
    EXPECT_EQ("", History("").problem());
    EXPECT_THAT(History(directory.path()).problem(), testing::EndsWith("is not kept: Is a directory"));
}

TEST(History, ALinkToTheFileIsKept) {
    const TempDir directory;
    std::string text;
    for (int i = 0; i != 1200; ++i) text += "line " + std::to_string(i) + "\n";
    const std::string file = directory.write("history", text), link = directory / "link";
    std::filesystem::create_symlink(file, link);
    const History history(link);
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(0u, readFile(file).find("line 200\n"));
}

TEST(History, WhoMayReadTheFileStaysSo) {
    const TempDir directory;
    std::string text;
    for (int i = 0; i != 1200; ++i) text += "line " + std::to_string(i) + "\n";
    const std::string file = directory.write("history", text);
    constexpr auto kOwn = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
    std::filesystem::permissions(file, kOwn);
    const History history(file);
    EXPECT_EQ(0u, readFile(file).find("line 200\n")) << "it was not written anew";
    EXPECT_EQ(kOwn, std::filesystem::status(file).permissions());
}

TEST(History, KeepsTheLastThousandLines) {
    const TempDir directory;
    std::string text;
    for (int i = 0; i != 1200; ++i) text += "line " + std::to_string(i) + "\n";
    const std::string file = directory.write("history", text);
    History history(file);
    ASSERT_EQ(1000u, history.lines().size());
    EXPECT_EQ("line 200", history.lines().front());
    EXPECT_EQ("line 1199", history.lines().back());
    EXPECT_EQ(0u, readFile(file).find("line 200\n"));
    history.add("one more");
    EXPECT_EQ(1000u, history.lines().size());
}

TEST(History, ItsFileIsThatOfTheEnvironment) {
    setenv("ORO_TB_HISTFILE", "/tmp/elsewhere", 1);
    EXPECT_EQ("/tmp/elsewhere", OCL::console::historyFile());
    setenv("ORO_TB_HISTFILE", "~/elsewhere", 1);
    EXPECT_EQ(std::getenv("HOME") + std::string("/elsewhere"), OCL::console::historyFile());
    unsetenv("ORO_TB_HISTFILE");
    const TempDir directory;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(directory.path());
    EXPECT_EQ(".tb_history", OCL::console::historyFile());
    std::filesystem::current_path(before);
}

}  // namespace
