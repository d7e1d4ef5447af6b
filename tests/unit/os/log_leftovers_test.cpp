// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Log files of processes that ran side by side: which of them are deleted, and which never.
#include "log_probe_run.hpp"

#include <csignal>
#include <gmock/gmock.h>
#include <list>

#include <sys/stat.h>
#include <unistd.h>

using namespace os_test;
using oroforge::test::ChildProcess;
using oroforge::test::Command;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

namespace {

class LogLeftovers : public testing::Test {
protected:
    Command staying(Environment environment = {}) const {
        Command command = probeCommand(directory.path(), std::move(environment), {"--stay"});
        command.inputStaysOpen = true;
        return command;
    }
    /** Beside a process that writes orocos.log. Returns the name of its file. */
    std::string runBeside(const Environment& environment = {}, const std::vector<std::string>& words = {}) {
        ChildProcess child(probeCommand(directory.path(), environment, words));
        const std::string own = "orocos-" + std::to_string(child.pid()) + ".log";
        EXPECT_EQ(child.finish().status, 0);
        return own;
    }
    std::string path(const std::string& name) const { return (directory.path() / name).string(); }
    std::string read(const std::string& name) const { return contentOf(directory.path() / name); }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(directory.path()))
            all.push_back(entry.path().filename().string());
        return all;
    }
    void SetUp() override { ASSERT_TRUE(first.waitForOutput("staying", std::chrono::seconds(20))); }
    void TearDown() override { first.send(SIGKILL); }
    oroforge::test::TempDir directory;
    ChildProcess first{staying()};
};

TEST_F(LogLeftovers, TheLatestFilesStay) {
    std::vector<std::string> own;
    for (int i = 0; i < 5; ++i) own.push_back(runBeside());
    EXPECT_THAT(names(), testing::UnorderedElementsAre("orocos.log", own[1], own[2], own[3], own[4]));
    EXPECT_THAT(read(own[4]), HasSubstr("deleted log files that 1 earlier process wrote instead of 'orocos.log'"));
    first.send(SIGKILL);
    (void)first.finish();
    EXPECT_EQ(oroforge::test::run(probeCommand(directory.path(), {{"ORO_LOGFILE_KEEP", "2"}}, {})).status, 0);
    EXPECT_THAT(names(), testing::UnorderedElementsAre("orocos.log", "orocos.log.1", own[3], own[4]));
    EXPECT_THAT(read("orocos.log"), HasSubstr("deleted log files that 2 earlier processes wrote"));
}

TEST_F(LogLeftovers, FilesOfLivingProcessesStay) {
    ChildProcess second(staying());
    ASSERT_TRUE(second.waitForOutput("staying", std::chrono::seconds(20)));
    const std::string living = "orocos-" + std::to_string(second.pid()) + ".log";
    const std::string left = runBeside({{"ORO_LOGFILE_KEEP", "0"}});
    EXPECT_THAT(names(), testing::IsSupersetOf({living, left}));
    const std::string last = runBeside({{"ORO_LOGFILE_KEEP", "0"}});
    EXPECT_THAT(names(), testing::UnorderedElementsAre("orocos.log", living, last));
    second.send(SIGKILL);
    (void)second.finish();
    (void)runBeside({{"ORO_LOGFILE_KEEP", "0"}});
    EXPECT_THAT(names(), Not(Contains(living)));
}

TEST_F(LogLeftovers, OtherFilesStay) {
    const std::string left = runBeside();
    const std::string first = read(left);
    std::filesystem::copy_file(path(left), path("orocos-7.log"));  // its first line names another file
    directory.write("orocos-8.log", "precious\n");
    directory.write("orocos-9.log", "");  // a process may just have made it
    directory.write("orocos-notes.log", first);
    directory.write("orocos-10-x.log", first);
    directory.write("robot-11.log", first);
    ASSERT_EQ(0, symlink(left.c_str(), path("orocos-12.log").c_str()));
    std::filesystem::create_directory(path("orocos-13.log"));
    std::string other = first;
    other.replace(other.find("'orocos.log'"), 12, "'motor.log'")
        .replace(other.find(left), left.size(), "orocos-14.log");
    directory.write("orocos-14.log", other);
    const std::vector<std::string> before = names();
    const std::string last = runBeside({{"ORO_LOGFILE_KEEP", "0"}});
    std::vector<std::string> after = before;
    after.erase(std::find(after.begin(), after.end(), left));
    after.push_back(last);
    EXPECT_THAT(names(), testing::UnorderedElementsAreArray(after));
    EXPECT_EQ(read("orocos-8.log"), "precious\n");
}

TEST_F(LogLeftovers, FilesOfAnotherUserStay) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can give a file away";
    const std::string left = runBeside();
    ASSERT_EQ(0, chown(path(left).c_str(), 65534, 65534));
    (void)runBeside({{"ORO_LOGFILE_KEEP", "0"}});
    EXPECT_THAT(names(), Contains(left));
}

TEST_F(LogLeftovers, EarlierFilesOfAProcessGoWithIt) {
    const std::string left = runBeside({{"ORO_LOGFILE_MAX", "10k"}, {"ORO_LOGFILE_KEEP", "2"}}, {"--much"});
    for (const char* const number : {"", ".1", ".2"}) {
        EXPECT_THAT(read(left + number), HasSubstr("this process writes '" + left + "'\n"));
        EXPECT_LE(read(left + number).size(), 10240U);
    }
    const std::string last = runBeside({{"ORO_LOGFILE_KEEP", "0"}});
    EXPECT_THAT(names(), testing::UnorderedElementsAre("orocos.log", last));
}

TEST_F(LogLeftovers, ProcessesThatComeAndGoKeepTheFilesOfOthers) {
    std::list<ChildProcess> living, passing;
    for (int i = 0; i < 30; ++i) {
        passing.emplace_back(probeCommand(directory.path(), {{"ORO_LOGFILE_KEEP", "1"}}, {}));
        if (i % 5 == 0) living.emplace_back(staying({{"ORO_LOGFILE_KEEP", "1"}}));
    }
    for (ChildProcess& one : passing) EXPECT_EQ(one.finish().status, 0);
    std::size_t found = 0;
    for (ChildProcess& one : living) EXPECT_TRUE(one.waitForOutput("staying", std::chrono::seconds(20)));
    (void)runBeside({{"ORO_LOGFILE_KEEP", "1"}});
    for (const std::string& name : names()) found += count(read(name), "] staying\n");
    EXPECT_EQ(found, living.size() + 1);
    EXPECT_EQ(names().size(), living.size() + 3);  // orocos.log, one that is kept, and the last
    for (ChildProcess& one : living) one.send(SIGKILL);
}

}  // namespace
