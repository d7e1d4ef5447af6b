// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Receivers of the log: what they get, and what happens if they block, throw, log, or go away.
#include "log_probe_run.hpp"
#include "log_receivers.hpp"
#include "real_time_thread.hpp"

#include <rtt/LogReceiver.hpp>
#include <rtt/Logger.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <gmock/gmock.h>
#include <iostream>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

using namespace RTT;
using oroforge::test::becomeRealTime;
using oroforge::test::inRealTimeThread;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace {

using os_test::LogReceivers;
using os_test::Receiver;

/** Where the receiver's thread waits until the test lets it go. */
class Barrier {
public:
    void pass() {
        std::unique_lock<std::mutex> lock(mutex_);
        reached_ = true;
        changed_.notify_all();
        changed_.wait(lock, [&] { return open_; });
    }
    void waitUntilReached() {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [&] { return reached_; });
    }
    void open() {
        const std::lock_guard<std::mutex> lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool open_ = false, reached_ = false;
};

TEST_F(LogReceivers, GetTheLinesOfTheFile) {
    Receiver receiver;
    EXPECT_EQ(logger.setReceiver(&receiver), nullptr);
    {
        Logger::In in("part");
        log(Debug) << "nobody sees it" << endlog();
        log(Info) << "for the file" << endlog();
        log(Error) << "two\nlines" << endlog();
    }
    const bool realTime = inRealTimeThread([] {
        Logger::In in("control");
        log(Warning) << "real-time " << 1.5 << endlog();
    });
    EXPECT_EQ(logger.setReceiver(nullptr), &receiver);
    log(Error) << "too late" << endlog();
    const std::vector<std::string> all = {"[part] for the file", "[part] two\nlines", "[control] real-time 1.5"};
    EXPECT_EQ(receiver.lines(), std::vector<std::string>(all.begin(), all.end() - (realTime ? 0 : 1)));
    for (const char* text : {"[part] for the file\n", "[part] two\n    lines\n", "too late\n"})
        EXPECT_THAT(file(), HasSubstr(text));
}

TEST_F(LogReceivers, GetLevelAndTimes) {
    Receiver receiver;
    logger.setReceiver(&receiver);
    using std::chrono::system_clock;
    const auto now = [] { return std::chrono::nanoseconds(system_clock::now().time_since_epoch()).count(); };
    for (const bool realTime : {false, true}) {
        const auto wall = now();
        const auto ticks = os::TimeService::Instance()->getTicks(logger.getReferenceTime());
        const auto line = [] { log(Critical) << "x" << endlog(); };
        if (!realTime)
            line();
        else if (!inRealTimeThread(line))
            break;
        EXPECT_EQ(logger.setReceiver(&receiver), &receiver);
        const LogEntry entry = receiver.last();
        EXPECT_EQ(entry.level, Critical);
        EXPECT_GE(entry.wallTime, wall - 1000000000);
        EXPECT_LE(entry.wallTime, now() + 1000000000);
        EXPECT_GE(entry.time, ticks);
        EXPECT_LE(entry.time, os::TimeService::Instance()->getTicks(logger.getReferenceTime()));
        EXPECT_FALSE(entry.located);
        EXPECT_EQ(entry.cut, 0U);
    }
}

TEST_F(LogReceivers, MayReplaceTheFile) {
    Receiver receiver;
    logger.setReceiver(&receiver, LogReceiverUse::InsteadOfFile);
    log(Error) << "only for it" << endlog();
    logger.setReceiver(&receiver, LogReceiverUse::BesideFile);
    log(Error) << "for both" << endlog();
    logger.mayLogFile(false);
    log(Error) << "for none" << endlog();
    logger.mayLogFile(true);
    logger.setReceiver(nullptr);
    EXPECT_THAT(receiver.lines(), ElementsAre(HasSubstr("only for it"), HasSubstr("for both")));
    EXPECT_THAT(file(), Not(HasSubstr("only for it")));
    EXPECT_THAT(file(), HasSubstr("for both"));
    EXPECT_EQ(os_test::count(console.str(), "\n"), 3U);
}

TEST_F(LogReceivers, GetLinesWhereThereIsNoFile) {
    logger.shutdown();
    setenv("ORO_LOGFILE", (directory.path() / "no" / "such.log").c_str(), 1);
    logger.startup();
    Receiver receiver;
    logger.setReceiver(&receiver);
    log(Info) << "anyway" << endlog();
    logger.setReceiver(nullptr);
    EXPECT_THAT(receiver.lines(), ElementsAre(HasSubstr("anyway")));
}

TEST_F(LogReceivers, DoNotGetWhatTheyLog) {
    Receiver receiver([](const LogEntry&) { log(Error) << "from the receiver" << endlog(); });
    logger.setReceiver(&receiver, LogReceiverUse::InsteadOfFile);
    for (int i = 0; i < 10; ++i) log(Error) << "line" << endlog();
    logger.setReceiver(nullptr);
    EXPECT_EQ(receiver.lines().size(), 10U);
    EXPECT_THAT(receiver.lines(), Each(HasSubstr("line")));
    EXPECT_EQ(os_test::count(console.str(), "[log receiver] from the receiver\n"), 10U);
    EXPECT_EQ(os_test::count(file(), "[log receiver] from the receiver\n"), 10U);
}

TEST_F(LogReceivers, MayThrow) {
    Receiver receiver([](const LogEntry& entry) {
        if (entry.level == Error) throw std::runtime_error("no paper");
        throw 1;
    });
    logger.setReceiver(&receiver, LogReceiverUse::InsteadOfFile);
    for (int i = 0; i < 5; ++i) log(i % 2 ? Warning : Error) << "line " << i << endlog();
    logger.setReceiver(nullptr);
    EXPECT_EQ(receiver.lines().size(), 5U);
    EXPECT_EQ(os_test::count(console.str(), "[ Warning][Logger] the receiver of the log threw: no paper; "), 1U);
    EXPECT_EQ(os_test::count(console.str(), "threw"), 1U);
    EXPECT_EQ(os_test::count(file(), "] line "), 5U) << "none is lost";
}

TEST_F(LogReceivers, MayBlockWithoutDelayingAnybody) {
    Barrier barrier;
    Receiver receiver([&](const LogEntry&) { barrier.pass(); });
    logger.setReceiver(&receiver, LogReceiverUse::InsteadOfFile);
    for (int i = 0; i < 1500; ++i) {
        log(Error) << "line " << i << endlog();
        if (i == 0) barrier.waitUntilReached();
    }
    EXPECT_EQ(os_test::count(console.str(), "] line "), 1500U);
    EXPECT_EQ(os_test::count(file(), "] line "), 499U) << "one is being received, 1000 are waiting";
    barrier.open();
    logger.setReceiver(nullptr);
    EXPECT_EQ(os_test::count(file(), "] line "), 499U);
    const std::string warning =
        "499 line(s) not given to the receiver of the log, which was too slow: 1000 were waiting";
    const auto lines = receiver.lines();
    ASSERT_GE(lines.size(), 1001U);
    for (std::size_t i = 0; i < 1001; ++i) ASSERT_THAT(lines[i], HasSubstr("line " + std::to_string(i)));
    EXPECT_THAT(console.str(), HasSubstr("[ Warning][Logger] " + warning));
    EXPECT_THAT(lines.back(), HasSubstr("[Logger] " + warning));
}

TEST_F(LogReceivers, AreTakenAwayThoughTheyAreSlow) {
    Barrier barrier;
    Receiver receiver([&](const LogEntry&) { barrier.pass(); });
    logger.setReceiver(&receiver, LogReceiverUse::InsteadOfFile);
    for (int i = 0; i < 100; ++i) log(Error) << "line " << i << endlog();
    barrier.waitUntilReached();
    std::atomic<bool> gone{false};
    std::thread taker([&] {
        logger.setReceiver(nullptr);
        gone = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
    EXPECT_FALSE(gone) << "it is still being called";
    barrier.open();
    taker.join();
    EXPECT_EQ(receiver.lines().size(), 1U);
    EXPECT_EQ(os_test::count(file(), "] line "), 99U);
    EXPECT_THAT(console.str(), HasSubstr("99 line(s) not given to the receiver of the log, which was too slow"));
}

TEST_F(LogReceivers, MayTakeThemselvesAway) {
    Receiver receiver([this](const LogEntry&) { EXPECT_NE(logger.setReceiver(nullptr), nullptr); });
    logger.setReceiver(&receiver);
    log(Error) << "first" << endlog();
    for (int i = 0; i < 500 && receiver.lines().empty(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(logger.setReceiver(nullptr), nullptr);
    log(Error) << "second" << endlog();
    EXPECT_THAT(receiver.lines(), ElementsAre(HasSubstr("first")));
}

TEST_F(LogReceivers, StayWhenTheLogStartsAgain) {
    Receiver receiver;
    logger.setReceiver(&receiver, LogReceiverUse::InsteadOfFile);
    log(Error) << "before" << endlog();
    logger.shutdown();
    EXPECT_THAT(receiver.lines(), ElementsAre(HasSubstr("before"), HasSubstr("logging ends")));
    log(Error) << "between" << endlog();
    logger.startup();
    log(Error) << "after" << endlog();
    logger.setReceiver(nullptr);
    EXPECT_THAT(receiver.lines().back(), HasSubstr("after"));
    EXPECT_THAT(receiver.lines(), Each(Not(HasSubstr("between"))));
}

// Also the case for ThreadSanitizer.
TEST_F(LogReceivers, ComeAndGoWhileThreadsLog) {
    constexpr int kThreads = 4, kLines = 2000;
    std::atomic<int> running{kThreads};
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t)
        threads.emplace_back([&, t] {
            if (t % 2) becomeRealTime();
            Logger::In in(std::string(1, static_cast<char>('a' + t)));
            for (int i = 0; i < kLines; ++i) {
                log(Info) << "line " << i << endlog();
                if (i % 20 == 19) std::this_thread::sleep_for(std::chrono::microseconds(100));
            }
            --running;
        });
    std::size_t received = 0, lost = 0;
    // Those of real-time threads may have been lost, and then are counted.
    const auto addLost = [&lost](const std::string& line) {
        if (const std::size_t at = line.find(" line(s) of real-time threads lost"); at != std::string::npos)
            lost += static_cast<std::size_t>(std::atoi(line.c_str() + line.rfind(']', at) + 1));
    };
    while (running) {
        const auto receiver = std::make_unique<Receiver>([](const LogEntry& entry) {
            if (entry.text.back() == '7') throw std::runtime_error("seven");
            if (entry.text.back() == '8') log(Info) << "eight" << endlog();
        });
        logger.setReceiver(receiver.get(), LogReceiverUse::InsteadOfFile);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        EXPECT_EQ(logger.setReceiver(nullptr), receiver.get());
        for (const std::string& line : receiver->lines()) {
            if (os_test::count(line, "] line ") == 1 && line.back() != '7') ++received;
            addLost(line);
        }
    }
    for (auto& thread : threads) thread.join();
    const std::string text = file();
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) addLost(line);
    EXPECT_EQ(received + os_test::count(text, "] line ") + lost, std::size_t(kThreads) * kLines);
    EXPECT_GT(received, 0U);
}

#ifndef __SANITIZE_THREAD__
TEST_F(LogReceivers, DoNotGetTheLinesOfAChild) {
    Receiver receiver;
    logger.setReceiver(&receiver, LogReceiverUse::InsteadOfFile);
    log(Error) << "parent" << endlog();
    const pid_t child = fork();
    if (child == 0) {
        alarm(60);
        log(Error) << "child" << endlog();
        Receiver own;
        if (logger.setReceiver(&own) != nullptr) _exit(1);
        log(Error) << "child's own" << endlog();
        logger.setReceiver(nullptr);
        _exit(own.lines().size() == 1 ? 0 : 2);
    }
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    logger.setReceiver(nullptr);
    EXPECT_EQ(receiver.lines().size(), 1U);
    EXPECT_THAT(file(), HasSubstr("] child\n"));
}
#endif

TEST(LogReceiversAtTheEnd, AProcessEndsThoughOneBlocks) {
    const os_test::Probe probe(os_test::Environment{{"ORO_LOGLEVEL", "0"}}, {"--receiver"});
    EXPECT_EQ(probe.outcome.status, 0);
    EXPECT_EQ(os_test::count(probe.file, "for the receiver "), 49U) << "all but the one in progress";
    EXPECT_THAT(probe.file, HasSubstr("message 5"));
}

TEST(LogReceiversAtTheEnd, ACrashWritesWhatTheyDidNotGet) {
    const os_test::Probe probe(os_test::Environment{{"ORO_LOGLEVEL", "0"}}, {"--receiver", "--abort"});
    EXPECT_EQ(probe.outcome.status, 128 + SIGABRT);
    EXPECT_EQ(os_test::count(probe.file, "for the receiver "), 50U) << "also the one in progress";
}

}  // namespace
