// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Logger.hpp>
#include <rtt/internal/calls/failure_report.hpp>
#include <rtt/internal/located_log.hpp>

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <thread>

using namespace RTT;
using testing::HasSubstr;
using testing::Not;

namespace {

/** Length of "12.345 " at the beginning of a line, 0 if it does not begin like that. */
std::size_t stampSize(const std::string& line) {
    const std::size_t point = line.find_first_not_of("0123456789");
    if (point == 0 || point == std::string::npos || line[point] != '.') return 0;
    const std::size_t end = line.find_first_not_of("0123456789", point + 1);
    return end == point + 4 && line[end] == ' ' ? end + 1 : 0;
}

class LoggerTest : public testing::Test {
protected:
    LoggerTest() {
        logger.setLogLevel(Logger::Warning);
        logger.setStdStream(console);
        logger.in("Logger");
    }
    ~LoggerTest() override {
        logger.setStdStream(std::cerr);
        logger.mayLogStdOut(true);
        logger.mayLogFile(true);
    }
    /** The console without the time stamps. */
    std::string lines() const {
        std::istringstream all(console.str());
        std::string result;
        for (std::string line; std::getline(all, line);) result += line.substr(stampSize(line)) + "\n";
        return result;
    }

    std::ostringstream console;
    Logger& logger = *Logger::Instance();
};

}  // namespace

TEST_F(LoggerTest, NoTextPassesForALineOfItsOwn) {
    log(Error) << "first\n0.001 [ ERROR  ][forged] second\nthird\n" << endlog();
    EXPECT_EQ("[ ERROR  ][Logger] first\n    0.001 [ ERROR  ][forged] second\n    third\n\n", lines());
}

TEST_F(LoggerTest, ControlCharactersAreSpeltOut) {
    log(Error) << "a\rb\x1b[2Kc\x7f"
               << "d\te \u00e9 \u009b" << endlog();
    EXPECT_EQ(
        "[ ERROR  ][Logger] a\\x0db\\x1b[2Kc\\x7f"
        "d\te \u00e9 \\x9b\n",
        lines());
}

TEST_F(LoggerTest, NoModulePassesForALineOfItsOwn) {
    Logger::In in("forged]\n0.001 [ ERROR  ][other");
    log(Error) << "text" << endlog();
    EXPECT_EQ("[ ERROR  ][forged]\\x0a0.001 [ ERROR  ][other] text\n", lines());
}

TEST_F(LoggerTest, EverySpellingWorks) {
    RTT::log(RTT::Error) << "one " << 1 << RTT::endlog();
    log(Error) << std::string("two") << endlog();
    Logger::log(Logger::Error) << "three" << Logger::endl;
    Logger::log() << Logger::Critical << "four" << Logger::nl;
    log() << "five" << nlog() << Logger::LogLevel(Logger::Error) << "six" << endlog();
    log(Warning) << "seven" << endlog(Fatal);
    EXPECT_EQ(lines(),
              "[ ERROR  ][Logger] one 1\n[ ERROR  ][Logger] two\n[ ERROR  ][Logger] three\n"
              "[CRITICAL][Logger] four\n[CRITICAL][Logger] five\n[ ERROR  ][Logger] six\n[ FATAL  ][Logger] seven\n");
}

TEST_F(LoggerTest, LineBeginsWithTheSecondsSinceTheReferenceTime) {
    const double before = nsecs_to_Seconds(os::TimeService::Instance()->getTicks(logger.getReferenceTime()));
    log(Error) << "x" << endlog();
    const std::string text = console.str();
    ASSERT_GT(stampSize(text), 0u) << text;
    EXPECT_EQ(text.substr(stampSize(text)), "[ ERROR  ][Logger] x\n");
    EXPECT_NEAR(std::stod(text), before, 30.0);
}

TEST_F(LoggerTest, TextsThatBeginWithTheirPlaceStandAlone) {
    while (!logger.getLogLine().empty()) {
    }
    internal::logLocated(Error, "a.ops:1:2: error: x\n  x\n ^");
    log(Error) << "between" << endlog();
    internal::logLocated(Info, "hidden");
    internal::logLocated(Warning, "a.ops:3: warning: y");
    EXPECT_THAT(console.str(), testing::StartsWith("a.ops:1:2: error: x\n  x\n ^\n"));
    EXPECT_THAT(console.str(), testing::EndsWith("[ ERROR  ][Logger] between\na.ops:3: warning: y\n"));
    EXPECT_EQ(logger.getLogLine(), "a.ops:1:2: error: x\n  x\n ^");
}

TEST_F(LoggerTest, ErrorsThatSomebodyKeepsAreNotLogged) {
    {
        internal::KeptErrors kept;
        log(Error) << "one" << endlog();
        log(Warning) << "shown" << endlog();
        log(Error) << "two" << endlog();
        EXPECT_EQ(kept.take(), "one; two");
    }
    log(Error) << "three" << endlog();
    EXPECT_EQ(lines(), "[ Warning][Logger] shown\n[ ERROR  ][Logger] three\n");
}

TEST_F(LoggerTest, ErrorsThatNobodyTakesAndWorseOnesAreLogged) {
    try {
        const internal::KeptErrors kept;
        log(Error) << "one" << endlog();
        log(Critical) << "at once" << endlog();
        throw std::runtime_error("within");
    } catch (const std::runtime_error&) {
        log(Error) << "two" << endlog();
    }
    EXPECT_EQ(lines(), "[CRITICAL][Logger] at once\n[ ERROR  ][Logger] one\n[ ERROR  ][Logger] two\n");
}

TEST_F(LoggerTest, LevelSelectsWhatTheConsoleShows) {
    log(Info) << "hidden" << endlog();
    EXPECT_FALSE(logger.mayLogStdOut());
    EXPECT_TRUE(logger.mayLog());
    EXPECT_TRUE(logger.mayLogFile());
    logger.setLogLevel(Logger::Debug);
    EXPECT_EQ(logger.getLogLevel(), Logger::Debug);
    log(Debug) << "shown" << endlog();
    logger.setLogLevel(Logger::Never);
    log(Fatal) << "hidden" << endlog();
    EXPECT_EQ(lines(), "[ Debug  ][Logger] shown\n");
}

TEST_F(LoggerTest, LinesOfLevelNeverAreNotShown) {
    logger.setLogLevel(Logger::Debug);
    log(Never) << "hidden" << endlog();
    log(Debug) << "seen" << endlog();
    EXPECT_EQ(lines(), "[ Debug  ][Logger] seen\n");
    logger.setLogLevel(Logger::Warning);
}

TEST_F(LoggerTest, WhatNobodySeesIsNotFormatted) {
    static int formatted = 0;
    // A manipulator counts how often the text is made.
    const auto count = +[](std::ostream& s) -> std::ostream& {
        ++formatted;
        return s;
    };
    log(Debug) << count << endlog();
    EXPECT_EQ(formatted, 0);
    log(Warning) << count << endlog();
    EXPECT_EQ(formatted, 1);
}

TEST_F(LoggerTest, StdEndlDoesNotEndTheRecord) {
    log(Error) << "a" << std::endl << "b" << endlog();
    EXPECT_EQ(lines(), "[ ERROR  ][Logger] a\n    b\n");
}

TEST_F(LoggerTest, ManipulatorsLastOneLine) {
    log(Error) << std::hex << std::setw(4) << std::setfill('0') << 255 << nlog() << 255 << ' ' << std::fixed << 0.5
               << nlog() << 0.5 << endlog();
    EXPECT_EQ(lines(), "[ ERROR  ][Logger] 00ff\n[ ERROR  ][Logger] 255 0.500000\n[ ERROR  ][Logger] 0.5\n");
}

TEST_F(LoggerTest, ModuleIsThatOfTheScope) {
    {
        Logger::In outer("outer");
        {
            Logger::In inner(std::string("inner"));
            log(Error) << "1" << endlog();
        }
        log(Error) << "2" << endlog();
        EXPECT_EQ(logger.getLogModule(), "outer");
    }
    log(Error) << "3" << endlog();
    EXPECT_EQ(lines(), "[ ERROR  ][inner] 1\n[ ERROR  ][outer] 2\n[ ERROR  ][Logger] 3\n");
}

TEST_F(LoggerTest, OutputsCanBeSwitchedOff) {
    logger.mayLogStdOut(false);
    log(Error) << "x" << endlog();
    logger.mayLogFile(false);
    EXPECT_FALSE(logger.mayLog());
    EXPECT_EQ(console.str(), "");
}

TEST_F(LoggerTest, RecentLinesCanBeFetched) {
    while (!logger.getLogLine().empty()) {
    }
    log(Error) << "first" << endlog();
    log(Error) << "second" << endlog();
    EXPECT_THAT(logger.getLogLine(), testing::EndsWith("[ ERROR  ][Logger] first"));
    EXPECT_THAT(logger.getLogLine(), testing::EndsWith("second"));
    EXPECT_EQ(logger.getLogLine(), "");
    for (int i = 0; i < 1500; ++i) log(Error) << i << nlog();
    EXPECT_THAT(logger.getLogLine(), testing::EndsWith("] 500"));
}

TEST_F(LoggerTest, LogarithmsStayUsable) {
    EXPECT_EQ(log(1.0), 0.0);
    EXPECT_EQ(std::log(1.0), 0.0);
    EXPECT_EQ(log(1.0f), 0.0f);
    EXPECT_EQ(RTT::log(1), 0.0);
}

TEST_F(LoggerTest, SwitchOverLevelsCompiles) {
    switch (logger.getLogLevel()) {
        case Logger::Warning: break;
        default: FAIL();
    }
    const LoggerLevel& bound = Logger::Error;  // needs an address
    EXPECT_EQ(bound, RTT::Error);
}

// Also the case for ThreadSanitizer.
TEST_F(LoggerTest, LinesOfThreadsDoNotMix) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([t] {
            const std::string name(1, static_cast<char>('a' + t));
            Logger::In in(name);
            for (int i = 0; i < 500; ++i) {
                if (i % 2)
                    log(Error) << name << name << name << endlog();
                else
                    log(Warning) << name << name << nlog();
                log(Debug) << "unseen " << name << endlog();
            }
        });
    for (int i = 0; i < 100; ++i) {
        logger.mayLogFile(i % 2);
        logger.getLogLine();
    }
    for (auto& t : threads) t.join();
    std::istringstream all(lines());
    std::string line;
    int count = 0;
    while (std::getline(all, line)) {
        ASSERT_GT(line.size(), 12u) << line;
        const std::string name(1, line[11]);
        EXPECT_TRUE(line == "[ ERROR  ][" + name + "] " + name + name + name ||
                    line == "[ Warning][" + name + "] " + name + name)
            << line;
        ++count;
    }
    EXPECT_EQ(count, 2000);
}

TEST_F(LoggerTest, UnfinishedLineOfAThreadIsNotLost) {
    std::thread([] {
        Logger::Instance()->in("worker");
        log(Error) << "last words";
    }).join();
    EXPECT_EQ(lines(), "[ ERROR  ][worker] last words\n");
}
