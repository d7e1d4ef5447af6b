// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "child_process.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace oroforge::test {

namespace {

struct Pipe {
    int read = -1;
    int write = -1;
    Pipe() {
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
        read = ends[0];
        write = ends[1];
    }
};

std::vector<std::string> mergedEnvironment(const Command& command) {
    std::vector<std::string> result;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text(*entry);
        if (command.environment.count(text.substr(0, text.find('='))) == 0) result.push_back(text);
    }
    for (const auto& [name, value] : command.environment) result.push_back(name + "=" + value);
    return result;
}

std::vector<char*> pointersTo(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& text : strings) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

/// Standard input comes from an unnamed file, so that a child that never reads cannot block us.
int inputFile(const std::string& input) {
    if (input.empty()) return ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    char name[] = "/tmp/oroforge-stdin-XXXXXX";
    const int fd = ::mkostemp(name, O_CLOEXEC);
    if (fd < 0) throw std::runtime_error("no temporary file for standard input");
    ::unlink(name);
    for (std::size_t done = 0; done < input.size();) {
        const ssize_t n = ::write(fd, input.data() + done, input.size() - done);
        if (n <= 0) break;
        done += static_cast<std::size_t>(n);
    }
    ::lseek(fd, 0, SEEK_SET);
    return fd;
}

/// Reads what is there; closes and clears `fd` at end of file.
void drain(int& fd, std::string& into) {
    char buffer[4096];
    const ssize_t n = ::read(fd, buffer, sizeof buffer);
    if (n > 0) {
        into.append(buffer, static_cast<std::size_t>(n));
    } else {
        ::close(fd);
        fd = -1;
    }
}

}  // namespace

ChildProcess::ChildProcess(const Command& command) : deadline_(Clock::now() + command.timeout) {
    std::vector<std::string> argumentTexts{command.program};
    argumentTexts.insert(argumentTexts.end(), command.arguments.begin(), command.arguments.end());
    std::vector<std::string> environmentTexts = mergedEnvironment(command);
    const std::vector<char*> argv = pointersTo(argumentTexts);
    const std::vector<char*> envp = pointersTo(environmentTexts);
    const std::string directory = command.directory.string();
    int input = -1;
    if (command.inputStaysOpen) {
        const Pipe open;
        input = open.read;
        inFd_ = open.write;
    } else {
        input = inputFile(command.input);
    }
    Pipe out;
    Pipe err;
    pid_ = ::fork();
    if (pid_ == 0) {
        // Only async-signal-safe calls here: the test may have threads.
        ::setpgid(0, 0);
        ::signal(SIGHUP, SIG_DFL);  // which nohup has ignored, if it is what the tests are run by
        ::dup2(input, 0);
        ::dup2(out.write, 1);
        ::dup2(err.write, 2);
        if (!directory.empty() && ::chdir(directory.c_str()) != 0) ::_exit(126);
        ::execvpe(argv[0], argv.data(), envp.data());
        ::_exit(127);
    }
    ::close(input);
    ::close(out.write);
    ::close(err.write);
    outFd_ = out.read;
    errFd_ = err.read;
    if (pid_ < 0) throw std::runtime_error("cannot start " + command.program);
}

ChildProcess::~ChildProcess() {
    if (!reaped_) {
        ::kill(pid_, SIGKILL);
        reap();
    }
    for (const int descriptor : {inFd_, outFd_, errFd_})
        if (descriptor >= 0) ::close(descriptor);
}

void ChildProcess::send(int signal) const {
    if (!reaped_) ::kill(pid_, signal);
}

bool ChildProcess::pump(Clock::time_point until) {
    pollfd fds[2] = {{outFd_, POLLIN, 0}, {errFd_, POLLIN, 0}};
    if (outFd_ < 0 && errFd_ < 0) return false;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    const int ready = ::poll(fds, 2, static_cast<int>(std::clamp<long long>(left, 0, 1000)));
    if (ready <= 0) return true;
    if (fds[0].revents != 0) drain(outFd_, outcome_.out);
    if (fds[1].revents != 0) drain(errFd_, outcome_.err);
    return true;
}

bool ChildProcess::waitForOutput(const std::string& text, std::chrono::milliseconds limit) {
    const auto until = std::min(deadline_, Clock::now() + limit);
    while (outcome_.out.find(text) == std::string::npos) {
        if (Clock::now() >= until || !pump(until)) return outcome_.out.find(text) != std::string::npos;
    }
    return true;
}

Outcome ChildProcess::finish() {
    while (Clock::now() < deadline_ && pump(deadline_)) {
    }
    // A program that closed its output may still run.
    while (Clock::now() < deadline_ && !reaped_) {
        int status = 0;
        if (::waitpid(pid_, &status, WNOHANG) == pid_) {
            reaped_ = true;
            outcome_.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        } else {
            ::usleep(1000);
        }
    }
    if (!reaped_) {
        outcome_.timedOut = true;
        ::kill(pid_, SIGKILL);
        reap();
    }
    return outcome_;
}

void ChildProcess::reap() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    reaped_ = true;
    outcome_.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Outcome run(const Command& command) { return ChildProcess(command).finish(); }

}  // namespace oroforge::test
