// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The log file of deployers that share a folder, or cannot write it; and what they say of privileges that they lack.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

namespace {

using namespace oroforge::test;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class LogFileOfDeployers : public deployer_test::DeployerInDirectory {
protected:
    Outcome deploy(const std::string& file) {
        Command deployer = command({});
        deployer.environment["ORO_LOGFILE"] = file;
        return run(deployer);
    }
    std::string log() const { return readFile(directory_ / "orocos.log"); }

    /** Until a deployer that writes it catches signals, as it does before it has a thread. */
    bool waitForLog(const std::string& name = "orocos.log") const {
        for (int times = 0; times != 400; ++times, std::this_thread::sleep_for(std::chrono::milliseconds(25)))
            if (std::filesystem::exists(directory_ / name) &&
                count(readFile(directory_ / name), "creating thread") != 0)
                return true;
        return false;
    }

    static std::ptrdiff_t count(const std::string& text, const std::string& part) {
        std::ptrdiff_t found = 0;
        for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
        return found;
    }
};

TEST_F(LogFileOfDeployers, EachHasItsOwn) {
    ChildProcess first(lasting({"First"}));
    ASSERT_TRUE(waitForLog());
    ChildProcess second(lasting({"Second"}));
    const std::string own = "orocos-" + std::to_string(second.pid()) + ".log";
    ASSERT_TRUE(waitForLog(own));
    second.send(SIGTERM);
    (void)second.finish();
    EXPECT_THAT(readFile(directory_ / own), HasSubstr("log file 'orocos.log' is being written by another process"));
    EXPECT_EQ(1, count(readFile(directory_ / own), "logging ends"));
    EXPECT_EQ(1, count(log(), "logging starts at level"));
    EXPECT_EQ(0, count(log(), "logging ends"));
    first.send(SIGTERM);
    (void)first.finish();
    EXPECT_EQ(1, count(log(), "logging ends"));
    (void)run(command({"Later"}));
    EXPECT_EQ(1, count(log(), "logging starts at level"));
    EXPECT_EQ(1, count(readFile(directory_ / "orocos.log.1"), "logging starts at level"));
}

TEST_F(LogFileOfDeployers, LinesHaveTheTimeOnRequest) {
    for (const std::string value : {"wall", "relative"}) {
        (void)run(command({"--log-time=" + value}));
        const std::string wall = "[0-9]+-[0-9]+-[0-9]+T[0-9:]+\\.[0-9]+[+-][0-9]+:[0-9]+ \\[";
        EXPECT_THAT(log(), ContainsRegex("^" + (value == "wall" ? wall : "[0-9]+\\.[0-9]+ \\["))) << value;
    }
    const Outcome wrong = run(command({"--log-time=wal"}));
    EXPECT_EQ(255, wrong.status);
    EXPECT_THAT(wrong.err,
                HasSubstr("unknown value 'wal' of --log-time, expected 'relative' or 'wall'; did you mean 'wall'?"));
}

TEST_F(LogFileOfDeployers, UnwritableOneIsWarnedOf) {
    std::filesystem::create_directory(directory_ / "orocos.log");
    EXPECT_THAT(deploy("").err,
                HasSubstr("[ Warning][Logger] no log file: 'orocos.log' cannot be written: Is a directory"));
}

TEST_F(LogFileOfDeployers, FullDiskIsWarnedOfOnce) {
    const Outcome outcome = deploy("/dev/full");
    EXPECT_EQ(0, outcome.status);
    EXPECT_EQ(1, count(outcome.err, "the log file lacks lines that cannot be written: No space left on device"))
        << outcome.err;
}

TEST_F(LogFileOfDeployers, LinkOfAnotherUserIsNotFollowed) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can give links away";
    directory_.write("precious", "kept");
    const std::string link = directory_ / "orocos.log";
    ASSERT_EQ(0, symlink("precious", link.c_str()));
    ASSERT_EQ(0, lchown(link.c_str(), 65534, 65534));
    EXPECT_THAT(deploy("orocos.log").err,
                HasSubstr("no log file: 'orocos.log' cannot be written: it is a symbolic link of another user"));
    EXPECT_EQ("kept", readFile(directory_ / "precious"));
    ASSERT_EQ(0, lchown(link.c_str(), 0, 0));
    EXPECT_THAT(deploy("orocos.log").err, Not(HasSubstr("no log file")));
    EXPECT_THAT(readFile(directory_ / "precious"), HasSubstr("logging ends"));
}

class MissingPrivilege : public LogFileOfDeployers {
protected:
    /** Without limits and capabilities that let it have real-time threads and locked memory. */
    Outcome restricted(const std::vector<std::string>& words) {
        Command deployer = command({"--rtprio=0:0", "--memlock=65536:65536"});
        deployer.program = "prlimit";
        if (geteuid() == 0)
            deployer.arguments.insert(deployer.arguments.end(), {"setpriv", "--bounding-set=-sys_nice,-ipc_lock"});
        deployer.arguments.push_back(DEPLOYER_PROGRAM);
        deployer.arguments.insert(deployer.arguments.end(), words.begin(), words.end());
        return run(deployer);
    }
};

std::string realTime(const std::string& name) {
    return "<struct name='" + name +
           "' type='deploytest::Consumer'><struct name='Activity' type='Activity'>"
           "<simple name='Period' type='double'><value>0.01</value></simple>"
           "<simple name='Priority' type='short'><value>50</value></simple>"
           "<simple name='Scheduler' type='string'><value>ORO_SCHED_RT</value></simple></struct></struct>";
}

TEST_F(MissingPrivilege, OfPrioritiesIsOneWarningWithItsCure) {
    directory_.write("app.xml", "<properties><simple name='Import' type='string'><value>deploytest</value></simple>" +
                                    realTime("a") + realTime("b") + realTime("c") + "</properties>");
    const Outcome outcome = restricted({"-s", "app.xml"});
    EXPECT_EQ(1, count(outcome.err, "using ORO_SCHED_OTHER")) << outcome.err;
    EXPECT_THAT(outcome.err,
                HasSubstr("thread 'a': ORO_SCHED_RT needs the capability CAP_SYS_NICE or an rtprio limit"));
    EXPECT_THAT(outcome.err, ContainsRegex("/etc/security/limits.d with the line '[^ ]+ - rtprio 99'"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("has no meaning")));
    for (const std::string name : {"a", "b", "c"})
        EXPECT_THAT(log(), HasSubstr("thread '" + name + "': ORO_SCHED_RT needs"));
}

TEST_F(MissingPrivilege, ToLockMemoryIsAWarningWithItsCure) {
    directory_.write("says.ops", "displayComponentTypes()\n");
    const Outcome outcome = restricted({"--lock-memory", "-s", "says.ops"});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.err,
                HasSubstr("warning: --lock-memory: the memory is not locked: the memlock limit of this user "
                          "is not 'unlimited'; allow it by a line"));
    EXPECT_THAT(outcome.out, HasSubstr("I can create"));
    EXPECT_THAT(restricted({}).err, Not(HasSubstr("memlock")));
}

#ifndef __SANITIZE_ADDRESS__  // it lets no program lock its memory
TEST_F(LogFileOfDeployers, MemoryIsLockedWhereThatIsAllowed) {
    ChildProcess deployer(lasting({"--lock-memory"}));
    ASSERT_TRUE(waitForLog());
    const std::string status = readFile("/proc/" + std::to_string(deployer.pid()) + "/status");
    deployer.send(SIGTERM);
    const Outcome outcome = deployer.finish();
    if (outcome.err.find("--lock-memory: the memory is not locked") != std::string::npos)
        GTEST_SKIP() << "no privilege to lock memory";
    EXPECT_THAT(status, Not(ContainsRegex("VmLck:[ \t]*0 kB")));
}
#endif

}  // namespace
