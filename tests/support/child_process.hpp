// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Runs programs in tests.
#ifndef OROFORGE_TESTS_SUPPORT_CHILD_PROCESS_HPP
#define OROFORGE_TESTS_SUPPORT_CHILD_PROCESS_HPP

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <sys/types.h>

namespace oroforge::test {

struct Command {
    std::string program;  ///< looked up in PATH if it has no '/'
    std::vector<std::string> arguments;
    std::filesystem::path directory;                 ///< where it runs; empty = here
    std::map<std::string, std::string> environment;  ///< added to, or replacing, what this process has
    std::string input;                               ///< its standard input
    bool inputStaysOpen = false;                     ///< instead, empty, as long as the ChildProcess lives
    std::chrono::milliseconds timeout{60000};        ///< then it is killed
};

struct Outcome {
    int status = -1;  ///< exit status, or 128 + signal number
    bool timedOut = false;
    std::string out;
    std::string err;
};

/// Starts at construction; output is collected in the background of waitFor…() and finish().
class ChildProcess {
public:
    explicit ChildProcess(const Command& command);
    ~ChildProcess();  ///< kills it if it still runs
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    pid_t pid() const { return pid_; }
    void send(int signal) const;

    /// True as soon as standard output contains `text`; false at the timeout or the end of the program.
    bool waitForOutput(const std::string& text, std::chrono::milliseconds limit);

    /// Waits for the end (kills at the command's timeout) and returns everything.
    Outcome finish();

private:
    using Clock = std::chrono::steady_clock;
    bool pump(Clock::time_point until);  // false when both pipes are closed
    void reap();

    pid_t pid_ = -1;
    int inFd_ = -1;
    int outFd_ = -1;
    int errFd_ = -1;
    bool reaped_ = false;
    Clock::time_point deadline_;
    Outcome outcome_;
};

/// Runs to the end.
Outcome run(const Command& command);

}  // namespace oroforge::test

#endif
