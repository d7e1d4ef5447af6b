// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The log in all its spellings.
#include <rtt/Logger.hpp>
#include <rtt/RTT.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

/** What is logged to the console meanwhile. */
class Console {
public:
    std::ostringstream text;
    Logger::LogLevel level;
    Console() : level(Logger::Instance()->getLogLevel()) {
        Logger::Instance()->setStdStream(text);
        Logger::Instance()->setLogLevel(Logger::Debug);
    }
    ~Console() {
        Logger::Instance()->setLogLevel(level);
        Logger::Instance()->setStdStream(std::cerr);
    }
    std::string str() {
        Logger::Instance()->logflush();
        return text.str();
    }
    bool has(const std::string& what) { return str().find(what) != std::string::npos; }
};

class Speaker : public TaskContext {
public:
    Speaker() : TaskContext("speaker") {}
    void speak() {
        Logger::In in(this->getName());
        log(Info) << "one " << 1 << endlog();
        RTT::log(RTT::Warning) << "two " << 2.5 << RTT::endlog();
        Logger::log(Logger::Error) << "three" << Logger::endl;
        Logger::log() << Logger::Debug << "four" << Logger::nl;
        RTT::Logger::log(RTT::Logger::Info) << "five" << RTT::Logger::endl;
        log(Debug) << "six" << nlog();
        log(Fatal) << std::string("seven") << endlog();
        log(Critical) << "eight" << std::endl;
        log() << "nine" << endlog(Error);
    }
};

}  // namespace

TEST(UserCode, LogsInEverySpelling) {
    Console console;
    Speaker speaker;
    speaker.speak();
    const char* lines[] = {"one 1", "two 2.5", "three", "four", "five", "six", "seven", "eight", "nine"};
    for (size_t i = 0; i != 9; ++i) EXPECT_TRUE(console.has(lines[i])) << lines[i] << " in\n" << console.str();
    EXPECT_TRUE(console.has("[speaker]"));
    Logger::Instance()->setLogLevel(Logger::Warning);
    log(Info) << "ten" << endlog();
    EXPECT_FALSE(console.has("ten"));
    EXPECT_TRUE(Logger::Instance()->getLogLevel() == Logger::Warning);
    LoggerLevel level = RTT::Error;
    log(level) << "eleven" << endlog();
    EXPECT_TRUE(console.has("eleven"));
    Logger::Instance()->setLogLevel(Logger::Never);
    log(Fatal) << "twelve" << endlog();
    EXPECT_FALSE(console.has("twelve"));
}

TEST(UserCode, AsksTheLogger) {
    Console console;
    RTT::Logger* logger = RTT::Logger::Instance();
    logger->in("module");
    EXPECT_EQ(logger->getLogModule(), "module");
    logger->out("");
    Logger::log().in("chained") << Logger::Info << "in one line" << Logger::endl;
    EXPECT_TRUE(console.has("chained"));
    logger->out("");
    logger->log(RTT::Logger::Info) << "direct" << RTT::Logger::endl;
    logger->logendl();
    logger->lognl();
    EXPECT_TRUE(console.has("direct"));
    logger->mayLogStdOut(false);
    log(Error) << "silent" << endlog();
    logger->mayLogStdOut(true);
    EXPECT_FALSE(console.has("silent"));
    EXPECT_TRUE(logger->mayLogStdOut());
    if (Logger::log().getLogLevel() < Logger::Info) FAIL();
    EXPECT_GE(double(logger->getReferenceTime()), 0.0);
}
