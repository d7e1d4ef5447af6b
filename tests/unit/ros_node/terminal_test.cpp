// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A program whose standard input is the terminal of another session, as of a node that roslaunch has started.
#include "programs.hpp"

#include <rtt/rtt-config.h>

#include <gmock/gmock.h>

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace ros_node_test;
using oroforge::test::TempDir;

/** Starts the program in a session of its own, with that terminal. */
pid_t startAt(const char* terminal, const std::string& program, const char* argument, const TempDir& folder) {
    const pid_t child = fork();
    if (child != 0) return child;
    setsid();
    const int fd = open(terminal, O_RDWR | O_NOCTTY);
    for (int number = 0; number < 3; ++number) dup2(fd, number);
    if (fd < 0 || chdir(folder.path().c_str()) != 0) _exit(100);
    const std::string path = kPrefix + "/bin/" + program + "-" OROCOS_TARGET_NAME;
    execl(path.c_str(), path.c_str(), argument, static_cast<char*>(nullptr));
    _exit(101);
}

class ForeignTerminal : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(ForeignTerminal, HasNoConsole) {
    useToolchain();
    unsetenv("ORO_NO_CONSOLE");
    const int controller = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_TRUE(controller >= 0 && grantpt(controller) == 0 && unlockpt(controller) == 0);
    TempDir folder;
    const pid_t child = startAt(ptsname(controller), GetParam().first, GetParam().second, folder);
    const int held = open(ptsname(controller), O_RDWR | O_NOCTTY | O_CLOEXEC);
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    ASSERT_EQ(5, write(controller, "quit\n", 5));  // for another program
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    int status = 0;
    EXPECT_EQ(0, waitpid(child, &status, WNOHANG)) << "it has ended";
    kill(child, SIGINT);
    rusage used = {};
    EXPECT_EQ(child, wait4(child, &status, 0, &used));
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_LT(used.ru_utime.tv_sec * 1000000 + used.ru_utime.tv_usec, 500000) << "a busy loop";
    fcntl(held, F_SETFL, O_NONBLOCK);
    char line[16];
    EXPECT_EQ(5, read(held, line, sizeof line)) << "it has read what was typed for another program";
    close(held);
    close(controller);
}

INSTANTIATE_TEST_SUITE_P(Programs, ForeignTerminal,
                         testing::Values(std::make_pair("deployer", "-linfo"), std::make_pair("rttlua", "-i")),
                         [](const auto& tested) { return std::string(tested.param.first); });

}  // namespace
