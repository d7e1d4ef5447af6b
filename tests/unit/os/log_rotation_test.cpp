// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Log files of earlier processes, of others that run, and files that get too large.
#include "log_probe_run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <gmock/gmock.h>
#include <list>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace os_test;
using oroforge::test::ChildProcess;
using oroforge::test::Command;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

namespace {

class LogRotation : public testing::Test {
protected:
    oroforge::test::Outcome run(const Environment& environment = {}, const std::vector<std::string>& words = {}) {
        return oroforge::test::run(probeCommand(directory.path(), environment, words));
    }
    Command staying(Environment environment = {}) const {
        Command command = probeCommand(directory.path(), std::move(environment), {"--stay"});
        command.inputStaysOpen = true;
        return command;
    }
    std::string read(const std::string& name) const { return contentOf(directory.path() / name); }
    void write(const std::string& name, const std::string& text) const { directory.write(name, text); }
    std::string path(const std::string& name) const { return (directory.path() / name).string(); }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(directory.path()))
            all.push_back(entry.path().filename().string());
        return all;
    }
    /** The lines of all files. */
    std::string everything() const {
        std::string all;
        for (const std::string& name : names()) all += read(name);
        return all;
    }
    oroforge::test::TempDir directory;
};

TEST_F(LogRotation, FilesOfEarlierProcessesAreKept) {
    for (const char* text : {"a", "b", "c", "d", "e"}) {
        write("orocos.log", text);
        EXPECT_EQ(run().status, 0);
        EXPECT_EQ(read("orocos.log.1"), text);
        EXPECT_THAT(read("orocos.log"), HasSubstr("the log file of an earlier process is 'orocos.log.1' now"));
    }
    EXPECT_EQ(read("orocos.log.2"), "d");
    EXPECT_EQ(read("orocos.log.3"), "c");
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log", "orocos.log.1", "orocos.log.2", "orocos.log.3"));
}

TEST_F(LogRotation, TheNumberOfFilesCanBeChosen) {
    write("orocos.log", "a");
    run({{"ORO_LOGFILE_KEEP", "0"}});
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log"));
    EXPECT_THAT(read("orocos.log"), Not(StartsWith("a")));
    for (const char* text : {"b", "c"}) {
        write("orocos.log", text);
        run({{"ORO_LOGFILE_KEEP", "1"}});
    }
    EXPECT_EQ(read("orocos.log.1"), "c");
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log", "orocos.log.1"));
}

TEST_F(LogRotation, AGapIsFilledBeforeAFileIsLost) {
    write("orocos.log", "a");
    write("orocos.log.1", "b");
    write("orocos.log.3", "c");
    run();
    EXPECT_EQ(read("orocos.log.1") + read("orocos.log.2") + read("orocos.log.3"), "abc");
}

TEST_F(LogRotation, AnEmptyFileIsNotKept) {
    write("orocos.log", "");
    run();
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log"));
}

TEST_F(LogRotation, ModeOfTheFileStays) {
    write("orocos.log", "a");
    ASSERT_EQ(0, chmod(path("orocos.log").c_str(), 0600));
    run();
    struct stat status {};
    ASSERT_EQ(0, stat(path("orocos.log").c_str(), &status));
    EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(LogRotation, FileOfALivingProcessIsNotTouched) {
    ChildProcess first(staying());
    ASSERT_TRUE(first.waitForOutput("staying", std::chrono::seconds(20)));
    struct stat before {
    }, after{};
    ASSERT_EQ(0, stat(path("orocos.log").c_str(), &before));
    ChildProcess second(staying({{"ORO_LOGLEVEL", "5"}}));
    ASSERT_TRUE(second.waitForOutput("staying", std::chrono::seconds(20)));
    const std::string own = "orocos-" + std::to_string(second.pid()) + ".log";
    ASSERT_EQ(0, stat(path("orocos.log").c_str(), &after));
    EXPECT_EQ(before.st_ino, after.st_ino);
    EXPECT_EQ(before.st_size, after.st_size);
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log", own));
    const std::string note =
        "[Logger] log file 'orocos.log' is being written by another process; this process writes '" + own + "'\n";
    const std::string text = read(own);
    EXPECT_THAT(text.substr(0, text.find('\n') + 1), HasSubstr(note));
    second.send(SIGKILL);
    EXPECT_THAT(second.finish().err, HasSubstr(note));
    first.send(SIGKILL);
    (void)first.finish();
    EXPECT_EQ(run().status, 0);  // the kernel has released the lock
    EXPECT_EQ(count(read("orocos.log.1"), "] staying\n"), 1U);
}

TEST_F(LogRotation, TwentyProcessesAtOnceLoseNothing) {
    write("orocos.log", "earlier\n");
    std::list<ChildProcess> all;
    for (int i = 0; i < 20; ++i) all.emplace_back(staying());
    for (ChildProcess& one : all) EXPECT_TRUE(one.waitForOutput("staying", std::chrono::seconds(30)));
    EXPECT_EQ(names().size(), 21U);
    EXPECT_EQ(read("orocos.log.1"), "earlier\n");
    for (const std::string& name : names())
        if (name != "orocos.log.1") EXPECT_EQ(count(read(name), "] staying\n"), 1U) << name;
    for (ChildProcess& one : all) one.send(SIGKILL);
}

TEST_F(LogRotation, ProcessesThatComeAndGoLoseNothing) {
    constexpr int kProcesses = 40;
    for (const char* noLinks : {"", "1"}) {
        std::list<ChildProcess> all;
        for (int i = 0; i < kProcesses; ++i)
            all.emplace_back(
                probeCommand(directory.path(), {{"ORO_LOGFILE_KEEP", "1000"}, {"LOG_PROBE_NO_LINKS", noLinks}}, {}));
        for (ChildProcess& one : all) EXPECT_EQ(one.finish().status, 0);
    }
    EXPECT_EQ(count(everything(), "] message 5\n"), 2U * kProcesses);
    for (const std::string& name : names()) {
        EXPECT_EQ(count(read(name), "] message 5\n"), 1U) << name;
        EXPECT_THAT(name, Not(HasSubstr(".new")));
    }
}

TEST_F(LogRotation, WorksWithoutHardLinks) {
    write("orocos.log", "a");
    run({{"LOG_PROBE_NO_LINKS", "1"}});
    EXPECT_EQ(read("orocos.log.1"), "a");
    EXPECT_THAT(read("orocos.log"), HasSubstr("message 5"));
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log", "orocos.log.1"));
}

TEST_F(LogRotation, WithoutHardLinksAnotherProcessMayBeFaster) {
    write("orocos.log", "a");
    EXPECT_EQ(run({{"LOG_PROBE_NO_LINKS", "1"}, {"LOG_PROBE_LATE_LOCK", "1"}}).status, 0);
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log", "orocos.log.1", "orocos.log.2"));
    EXPECT_EQ(read("orocos.log.2"), "a");
    for (const char* name : {"orocos.log", "orocos.log.1"}) EXPECT_EQ(count(read(name), "] message 5\n"), 1U) << name;
}

TEST_F(LogRotation, ADeathBetweenTheStepsLosesNothing) {
    write("orocos.log", "a");
    write("orocos.log.2", "b");
    ASSERT_EQ(0, link(path("orocos.log").c_str(), path("orocos.log.1").c_str()));
    run();
    EXPECT_EQ(read("orocos.log.1"), "a");
    EXPECT_EQ(read("orocos.log.2"), "b");
    EXPECT_THAT(read("orocos.log"), HasSubstr("message 5"));
}

TEST_F(LogRotation, FileThatCannotBeRenamedIsAddedTo) {
    write("orocos.log", "a\n");
    std::filesystem::create_directories(directory.path() / "orocos.log.1" / "full");
    const auto outcome = run({{"ORO_LOGFILE_KEEP", "1"}});
    EXPECT_THAT(outcome.err, HasSubstr("[ Warning][Logger] the log file 'orocos.log' of an earlier process cannot be "
                                       "renamed: File exists; lines are added to it"));
    EXPECT_THAT(read("orocos.log"), StartsWith("a\n"));
    EXPECT_THAT(read("orocos.log"), HasSubstr("message 5"));
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log", "orocos.log.1"));
}

TEST_F(LogRotation, LinkStaysAndItsTargetIsKept) {
    std::filesystem::create_directory(directory.path() / "disk");
    write("disk/robot.log", "a");
    ASSERT_EQ(0, symlink("disk/robot.log", path("orocos.log").c_str()));
    run();
    EXPECT_TRUE(std::filesystem::is_symlink(path("orocos.log")));
    EXPECT_EQ(read("disk/robot.log.1"), "a");
    EXPECT_THAT(read("disk/robot.log"), HasSubstr("message 5"));
}

TEST_F(LogRotation, NamesWithAndWithoutExtensionGetTheProcessId) {
    std::filesystem::create_directory(directory.path() / "logs.d");
    for (const std::string name : {"logs.d/robot", ".robot", "a.b.txt"}) {
        ChildProcess first(staying({{"ORO_LOGFILE", name}}));
        ASSERT_TRUE(first.waitForOutput("staying", std::chrono::seconds(20)));
        ChildProcess second(staying({{"ORO_LOGFILE", name}}));
        ASSERT_TRUE(second.waitForOutput("staying", std::chrono::seconds(20)));
        const std::string id = "-" + std::to_string(second.pid());
        const std::string own = name == "a.b.txt" ? "a.b" + id + ".txt" : name + id;
        EXPECT_EQ(count(read(own), "] staying\n"), 1U) << own;
        second.send(SIGKILL);
        first.send(SIGKILL);
    }
}

TEST_F(LogRotation, FileOfAnotherUserIsLeftAlone) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";
    write("orocos.log", "precious");
    ASSERT_EQ(0, chmod(directory.path().c_str(), 0777));
    Command command = probeCommand(directory.path(), {}, {});
    command.arguments = {"--reuid=65534", "--regid=65534", "--clear-groups", command.program};
    command.program = "setpriv";
    const auto outcome = oroforge::test::run(command);
    if (outcome.status == 126 || outcome.status == 127) GTEST_SKIP() << "that user may not execute the program";
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(read("orocos.log"), "precious");
    EXPECT_THAT(everything(), HasSubstr("log file 'orocos.log' belongs to another user; this process writes 'orocos-"));
    EXPECT_EQ(names().size(), 2U);
}

TEST_F(LogRotation, FifoThatNobodyReadsDelaysNothing) {
    ASSERT_EQ(0, mkfifo(path("orocos.log").c_str(), 0600));
    const auto outcome = run({}, {"--much"});
    EXPECT_EQ(outcome.status, 0) << outcome.timedOut;
    EXPECT_THAT(outcome.err, HasSubstr("the log file lacks lines that cannot be written: Resource temporarily"));
    const int reader = open(path("orocos.log").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    EXPECT_EQ(run().status, 0);
    char text[8192];
    const ssize_t size = ::read(reader, text, sizeof text);
    close(reader);
    ASSERT_GT(size, 0);
    EXPECT_THAT(std::string(text, static_cast<std::size_t>(size)), HasSubstr("message 5"));
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log"));
}

TEST_F(LogRotation, TheOutputOfTheProcessIsNotRenamed) {
    const Command probe = probeCommand(directory.path(), {{"ORO_LOGFILE", "/dev/stderr"}}, {});
    Command shell = probe;
    shell.program = "sh";
    shell.arguments = {"-c", "echo before > all; exec " + probe.program + " 2>> all"};
    EXPECT_EQ(oroforge::test::run(shell).status, 0);
    EXPECT_THAT(names(), UnorderedElementsAre("all"));
    EXPECT_THAT(read("all"), StartsWith("before\n"));
    EXPECT_EQ(count(read("all"), "] message 4\n"), 2U);
}

TEST_F(LogRotation, AFileThatGetsTooLargeIsKept) {
    for (const char* noLinks : {"", "1"}) {
        EXPECT_EQ(run({{"ORO_LOGFILE", "big.log"},
                       {"ORO_LOGFILE_MAX", "10k"},
                       {"ORO_LOGFILE_KEEP", "100"},
                       {"LOG_PROBE_NO_LINKS", noLinks}},
                      {"--much"})
                      .status,
                  0);
        const std::string all = everything();
        for (int i = 0; i < 1000; ++i) ASSERT_EQ(count(all, "numbered " + std::to_string(i) + " "), 1U) << i;
        EXPECT_GT(names().size(), 8U);
        for (const std::string& name : names()) {
            EXPECT_LE(read(name).size(), 10240U) << name;
            EXPECT_EQ(read(name).back(), '\n') << name;
            std::filesystem::remove(directory.path() / name);
        }
    }
}

TEST_F(LogRotation, AFileThatGetsTooLargeMayBeEmptied) {
    run({{"ORO_LOGFILE_MAX", "10000"}, {"ORO_LOGFILE_KEEP", "0"}}, {"--much"});
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log"));
    EXPECT_LE(read("orocos.log").size(), 10000U);
    EXPECT_THAT(read("orocos.log"), HasSubstr("message 5"));
}

TEST_F(LogRotation, AFileWithoutAPlaceToGoGrowsOn) {
    std::filesystem::create_directories(directory.path() / "orocos.log.1" / "full");
    const auto outcome = run({{"ORO_LOGFILE_MAX", "10000"}, {"ORO_LOGFILE_KEEP", "1"}}, {"--much"});
    EXPECT_EQ(count(outcome.err, "has reached ORO_LOGFILE_MAX and cannot be renamed: File exists; it goes on growing"),
              1U)
        << outcome.err;
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(count(read("orocos.log"), "numbered " + std::to_string(i) + " "), 1U) << i;
}

#ifndef __SANITIZE_THREAD__
TEST_F(LogRotation, AChildOfTheProcessKeepsItsFile) {
    const auto outcome = run({{"ORO_LOGFILE_MAX", "10000"}}, {"--fork"});
    EXPECT_THAT(outcome.out, HasSubstr("child done"));
    EXPECT_THAT(names(), UnorderedElementsAre("orocos.log"));
    EXPECT_EQ(count(read("orocos.log"), "] before the fork\n"), 1U);
    EXPECT_EQ(count(read("orocos.log"), "numbered "), 1000U);
}
#endif

TEST_F(LogRotation, ValuesThatCannotBeReadAreWarnedOf) {
    for (const char* value : {"-1", "three", "1001", "2x"})
        EXPECT_THAT(run({{"ORO_LOGFILE_KEEP", value}}).err,
                    HasSubstr(std::string("environment variable ORO_LOGFILE_KEEP is '") + value +
                              "', expected a number of files from 0 to 1000; 3 are kept"));
    for (const char* value : {"-1", "much", "1kb", "1 k", "99999999999999999999", "99999999999g"})
        EXPECT_THAT(run({{"ORO_LOGFILE_MAX", value}}).err,
                    HasSubstr(std::string("environment variable ORO_LOGFILE_MAX is '") + value + "', expected"));
}

}  // namespace
