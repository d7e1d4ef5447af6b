// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Lines of real-time threads: who writes them, in what order, and what becomes of them when the process ends.
#include "real_time_thread.hpp"

#include <rtt/Logger.hpp>
#include <rtt/detail/log_sink.hpp>
#include <rtt/os/Thread.hpp>
#include <rtt/os/startstop.h>

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <condition_variable>
#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <iomanip>
#include <iostream>
#include <mutex>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

using namespace RTT;
using oroforge::test::inRealTimeThread;
using testing::HasSubstr;

namespace {

/** A console that can be made to stand still, and waited for. */
class Console : public std::streambuf {
public:
    void hold() {
        std::lock_guard<std::mutex> lock(mutex_);
        held_ = true;
    }
    void release() {
        std::lock_guard<std::mutex> lock(mutex_);
        held_ = false;
        changed_.notify_all();
    }
    /** Until this text has been written; false after a long time. */
    bool waitFor(const std::string& text) {
        std::unique_lock<std::mutex> lock(mutex_);
        return changed_.wait_for(lock, std::chrono::seconds(30), [&] { return text_.find(text) != std::string::npos; });
    }
    bool waitUntilHeld() {
        std::unique_lock<std::mutex> lock(mutex_);
        return changed_.wait_for(lock, std::chrono::seconds(30), [&] { return waiting_; });
    }
    std::string text() {
        std::lock_guard<std::mutex> lock(mutex_);
        return text_;
    }
    /** What follows "][module] " in each line. */
    std::string texts() {
        std::istringstream all(text());
        std::string result;
        for (std::string line; std::getline(all, line);) result += line.substr(line.find("] ") + 2) + "\n";
        return result;
    }

private:
    std::streamsize xsputn(const char* from, std::streamsize size) override {
        std::unique_lock<std::mutex> lock(mutex_);
        waiting_ = held_;
        changed_.notify_all();
        changed_.wait(lock, [&] { return !held_; });
        waiting_ = false;
        text_.append(from, static_cast<std::size_t>(size));
        changed_.notify_all();
        return size;
    }
    std::mutex mutex_;
    std::condition_variable changed_;
    std::string text_;
    bool held_ = false, waiting_ = false;
};

class RealTimeLog : public testing::Test {
protected:
    RealTimeLog() {
        __os_init(0, nullptr);
        logger.setLogLevel(Logger::Warning);
        logger.setStdStream(stream);
    }
    ~RealTimeLog() override {
        logger.setStdStream(std::cerr);
        __os_exit();
    }
    void SetUp() override {
        if (!inRealTimeThread([] {})) GTEST_SKIP() << "this process may not have real-time threads";
    }
    Console console;
    std::ostream stream{&console};
    Logger& logger = *Logger::Instance();
};

}  // namespace

TEST_F(RealTimeLog, ItsLinesAreWrittenByAnotherThread) {
    console.hold();
    inRealTimeThread([] {
        Logger::In in("control");
        log(Error) << "first " << 1 << endlog();
        log(Debug) << "nobody sees it" << endlog();
        log(Warning) << "second" << nlog() << "third" << endlog();
    });  // has ended though nothing could be written
    EXPECT_TRUE(console.waitUntilHeld());
    EXPECT_EQ(console.text(), "");
    console.release();
    EXPECT_TRUE(console.waitFor("third"));
    EXPECT_EQ(console.texts(), "first 1\nsecond\nthird\n");
    EXPECT_THAT(console.text(), HasSubstr("[ ERROR  ][control] first 1\n"));
    EXPECT_THAT(console.text(), HasSubstr("[ Warning][control] third\n"));
}

TEST_F(RealTimeLog, LinesOfOthersComeBehindThoseThatWereQueuedBefore) {
    for (int i = 0; i < 100; ++i) {
        inRealTimeThread([i] { log(Error) << "rt " << i << endlog(); });
        log(Error) << "main " << i << endlog();
    }
    std::string expected;
    for (int i = 0; i < 100; ++i) expected += "rt " + std::to_string(i) + "\nmain " + std::to_string(i) + "\n";
    EXPECT_EQ(console.texts(), expected) << "the main thread's line is written, so all before are";
}

TEST_F(RealTimeLog, QueuedLinesGoToTheStreamOfTheirTime) {
    std::ostringstream other;
    inRealTimeThread([] { log(Error) << "before" << endlog(); });
    logger.setStdStream(other);
    log(Error) << "after" << endlog();
    logger.setStdStream(stream);
    EXPECT_EQ(console.texts(), "before\n");
    EXPECT_THAT(other.str(), HasSubstr("after"));
}

TEST_F(RealTimeLog, SettingsCountAtTheTimeOfTheLine) {
    for (int i = 0; i < 100; ++i) {
        inRealTimeThread([i] { log(Warning) << "warning " << i << endlog(); });
        logger.setLogLevel(Logger::Error);
        EXPECT_THAT(console.text(), HasSubstr("] warning " + std::to_string(i) + "\n"));
        logger.setLogLevel(Logger::Warning);
    }
}

#ifndef __SANITIZE_THREAD__
TEST_F(RealTimeLog, AChildOfTheProcessLogsItsOwnLinesOnly) {
    for (int i = 0; i < 100; ++i) {
        inRealTimeThread([] { log(Error) << "parent" << endlog(); });
        const pid_t child = fork();
        if (child == 0) {
            alarm(60);
            const std::string before = console.texts();
            log(Error) << "child" << endlog();
            _exit(console.texts() == before + "child\n" ? 0 : 1);
        }
        int status = -1;
        waitpid(child, &status, 0);
        ASSERT_EQ(status, 0);
    }
}
#endif

TEST_F(RealTimeLog, LinesCanBeFetchedAtOnce) {
    while (!logger.getLogLine().empty()) {
    }
    inRealTimeThread([] {
        Logger::In in("control");
        log(Error) << "fetched" << endlog();
    });
    EXPECT_THAT(logger.getLogLine(), testing::EndsWith("[control] fetched"));
}

TEST_F(RealTimeLog, WhatFindsNoRoomIsCountedAndReported) {
    console.hold();
    constexpr int kMany = 2000;
    inRealTimeThread([] {
        for (int i = 0; i < kMany; ++i) log(Error) << "line " << i << endlog();
    });
    console.release();
    EXPECT_TRUE(console.waitFor("lost"));
    log(Error) << "end" << endlog();
    const std::string text = console.texts();
    EXPECT_THAT(console.text(), HasSubstr("[ Warning][Logger] "));
    int written = 0, lost = 0, last = -1;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        int number = 0;
        if (std::sscanf(line.c_str(), "line %d", &number) == 1) {
            EXPECT_GT(number, last);
            last = number;
            ++written;
        } else if (line != "end") {
            ASSERT_EQ(std::sscanf(line.c_str(), "%d line(s) of real-time threads lost", &number), 1) << line;
            lost += number;
        }
    }
    EXPECT_GE(written, static_cast<int>(detail::LogQueue::kCells));
    EXPECT_EQ(written + lost, kMany);
}

TEST_F(RealTimeLog, ALongLineIsCutAndSaysSo) {
    inRealTimeThread([] {
        Logger::In in("m");
        log(Error) << std::string(3000, 'x') << "tail" << endlog();
        log(Error) << std::setw(10) << std::hex << 255 << endlog();
    });
    log(Error) << std::string(5000, 'y') << endlog();
    const std::size_t shown = detail::LogQueue::kLongest - 1;
    EXPECT_EQ(console.texts(), std::string(shown, 'x') + " ... (" + std::to_string(3004 - shown) +
                                   " characters cut)\n        ff\n" + std::string(5000, 'y') + "\n");
}

TEST_F(RealTimeLog, ALongModuleNameIsCut) {
    inRealTimeThread([] {
        Logger::In in(std::string(300, 'm'));
        log(Error) << "x" << endlog();
    });
    log(Error) << "y" << endlog();
    EXPECT_THAT(console.text(), HasSubstr("[" + std::string(255, 'm') + "] x\n"));
    EXPECT_THAT(console.text(), HasSubstr("[main] y\n"));
}

TEST_F(RealTimeLog, AnUnfinishedLineIsWrittenWhenTheThreadEnds) {
    inRealTimeThread([] { log(Error) << "last words"; });
    EXPECT_TRUE(console.waitFor("last words\n"));
}

TEST_F(RealTimeLog, EndingTheRuntimeWritesTheQueue) {
    inRealTimeThread([] { log(Error) << "just before" << endlog(); });
    __os_exit();
    EXPECT_EQ(console.texts(), "just before\n");
    inRealTimeThread([] { log(Error) << "too late" << endlog(); });
    __os_init(0, nullptr);
    log(Error) << "again" << endlog();
    EXPECT_EQ(console.texts(), "just before\nagain\n");
}

// Also the case for ThreadSanitizer.
TEST_F(RealTimeLog, ThreadsOfBothKindsLoseAndMixNothing) {
    constexpr int kThreads = 4, kLines = 1000;
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t)
        threads.emplace_back([t] {
            if (t % 2) oroforge::test::becomeRealTime();
            const std::string name(1, static_cast<char>('a' + t));
            Logger::In in(name);
            for (int i = 0; i < kLines; ++i) {
                log(Error) << name << ' ' << i << endlog();
                log(Debug) << "unseen " << i << endlog();
                if (t % 2 && i % 20 == 19) std::this_thread::sleep_for(std::chrono::microseconds(200));
            }
        });
    for (int i = 0; i < 100; ++i) {
        logger.mayLogFile(i % 2);
        logger.getLogLine();
    }
    for (auto& thread : threads) thread.join();
    log(Error) << "end" << endlog();
    std::vector<int> next(kThreads, 0);
    int lost = 0;
    std::istringstream lines(console.texts());
    for (std::string line; std::getline(lines, line);) {
        if (line == "end") continue;
        int number = 0;
        if (std::sscanf(line.c_str(), "%d line(s)", &number) == 1) {
            lost += number;
            continue;
        }
        const auto t = static_cast<std::size_t>(line[0] - 'a');
        ASSERT_LT(t, next.size()) << line;
        ASSERT_EQ(std::sscanf(line.c_str() + 1, " %d", &number), 1) << line;
        ASSERT_GE(number, next[t]) << line;
        lost -= number - next[t];
        next[t] = number + 1;
    }
    for (int t = 0; t < kThreads; ++t) lost -= kLines - next[static_cast<std::size_t>(t)];
    EXPECT_EQ(lost, 0) << "every line is there, or counted";
}

namespace {

/** Runs log_end_probe, whose real-time thread keeps all others from running and then ends the process in this way. */
oroforge::test::Outcome endOf(const std::string& how, std::string& file) {
    const oroforge::test::TempDir directory;
    oroforge::test::Command command;
    command.program = LOG_END_PROBE;
    command.arguments = {how};
    command.directory = directory.path();
    command.environment = {{"ORO_LOGLEVEL", "4"}, {"ORO_LOGFILE", "end.log"}};
    const auto outcome = oroforge::test::run(command);
    std::ifstream in(directory.path() / "end.log");
    file.assign(std::istreambuf_iterator<char>(in), {});
    return outcome;
}

class LogAtTheEnd : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(LogAtTheEnd, NothingIsLost) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    for (const std::string signal : {"fault", "sent"})
        if (GetParam() == signal) GTEST_SKIP() << "the sanitizer handles this signal itself, so the runtime does not";
#endif
    if (!inRealTimeThread([] {})) GTEST_SKIP() << "this process may not have real-time threads";
    std::string file;
    const auto outcome = endOf(GetParam(), file);
    for (const std::string& text : {outcome.err, file})
        for (int i = 0; i < 100; ++i)
            ASSERT_THAT(text, HasSubstr("[ ERROR  ][probe] line " + std::to_string(i) + "\n")) << outcome.status;
    EXPECT_THAT(file, HasSubstr("[ Info   ][main] main, not flushed\n"));
    EXPECT_EQ(outcome.status == 0, std::string(GetParam()).find("exit") != std::string::npos) << outcome.status;
}

TEST(LogAfterMain, TheStreamThatWasGivenMayBeGone) {
    std::string file;
    EXPECT_EQ(endOf("stream_gone", file).status, 0);
    EXPECT_THAT(file, HasSubstr("into the stream"));
}

INSTANTIATE_TEST_SUITE_P(Ways, LogAtTheEnd,
                         testing::Values("exit", "exit_without_init", "abort", "terminate", "fault", "sent"));
