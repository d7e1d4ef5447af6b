// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Logging by categories in the deployer: from files, configured by log4cpp's own file, killed.
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace oroforge::test;
using std::chrono::seconds;
using testing::HasSubstr;
using testing::Not;

std::string simple(const std::string& name, const std::string& type, const std::string& value) {
    return "<simple name='" + name + "' type='" + type + "'><value>" + value + "</value></simple>";
}
std::string bag(const std::string& name, const std::string& entries) {
    return "<struct name='" + name + "' type='PropertyBag'>" + entries + "</struct>";
}
std::string started(const std::string& name, const std::string& type, const std::string& properties,
                    const std::string& more = {}) {
    return "<struct name='" + name + "' type='" + type + "'>" + bag("Properties", properties) + more +
           simple("AutoConf", "boolean", "1") + simple("AutoStart", "boolean", "1") + "</struct>";
}

/** An application whose component logs to the category "demo.worker". */
std::string application(const std::string& appender, int events) {
    return "<properties>" + simple("Import", "string", "ocl") + simple("Import", "string", "loggertest") + appender +
           started("logging", "OCL::logging::LoggingService",
                   simple("BufferSize", "long", "1000") + bag("Levels", simple("demo", "string", "debug")) +
                       bag("Additivity", simple("demo.worker", "boolean", "1")) +
                       bag("Appenders", simple("demo", "string", "appender")),
                   bag("Peers", "<simple type='string'><value>appender</value></simple>")) +
           started("worker", "loggertest::Worker", simple("events", "long", std::to_string(events))) + "</properties>";
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

class LoggingInDeployer : public testing::Test {
protected:
    Command deployer(std::vector<std::string> arguments) {
        Command command;
        command.program = DEPLOYER_PROGRAM;
        command.arguments = std::move(arguments);
        command.directory = directory_.path();
        command.environment = {{"RTT_COMPONENT_PATH", OCL_TEST_PATH}, {"ORO_LOGLEVEL", "4"}};
        command.timeout = seconds(40);
        return command;
    }
    std::string file(const std::string& name = "events.log") const { return readFile(directory_ / name); }
    TempDir directory_;
};

const std::string kFileAppender =
    started("appender", "OCL::logging::FileAppender",
            simple("Filename", "string", "events.log") + simple("LayoutName", "string", "pattern") +
                simple("LayoutPattern", "string", "%p %c [%t] %m%n") + simple("MaxEventsPerCycle", "long", "0"));

TEST_F(LoggingInDeployer, AnXmlFileSetsUpCategoriesAndAppenders) {
    directory_.write("app.xml", application(kFileAppender, 50));
    Command command = deployer({"-s", "app.xml"});
    command.input =
        "while worker.logged() < 50 { yield }\nlogging.logCategories()\nlogging.getCategoryPriorityName(\"demo\")\n"
        "logging.setCategoryPriority(\"demo\", logging.ERROR)\nvar LoggingEvent event\nevent.message = \"by a "
        "script\"\n"
        "event\nquit\n";
    const Outcome outcome = run(command);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("DEBUG"));
    EXPECT_THAT(outcome.out, HasSubstr("message = \"by a script\""));
    EXPECT_THAT(outcome.err, Not(HasSubstr("ERROR")));
    const std::vector<std::string> lines = linesOf(file());
    ASSERT_EQ(52u, lines.size());
    EXPECT_THAT(lines[0], testing::MatchesRegex("ERROR demo.worker .*by log4cpp"));
    EXPECT_THAT(lines[1], testing::MatchesRegex("DEBUG demo.worker .worker. event 0"));
    EXPECT_THAT(lines[51], HasSubstr("# countMaxPopped="));
}

TEST_F(LoggingInDeployer, APropertyFileOfLog4cppIsReadFirst) {
    directory_.write("app.xml", application(kFileAppender, 5));
    directory_.write("log4cpp.properties",
                     "log4cpp.rootCategory=ERROR, text\n"
                     "log4cpp.category.demo.worker=WARN\n"
                     "log4cpp.appender.text=FileAppender\n"
                     "log4cpp.appender.text.fileName=text.log\n"
                     "log4cpp.appender.text.layout=SimpleLayout\n");
    for (const char* option : {"--log4cpp-config", "--rtt-log4cpp-config-file"}) {
        Command command = deployer({"-s", "app.xml", option, "log4cpp.properties"});
        command.input = "logging.getCategoryPriorityName(\"demo.worker\")\nquit\n";
        const Outcome outcome = run(command);
        EXPECT_EQ(0, outcome.status) << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("WARN"));
        // It is of log4cpp's own interface; the events of real-time threads, below WARN, are left out.
        EXPECT_THAT(file("text.log"), HasSubstr("ERROR   : by log4cpp"));
        EXPECT_THAT(file(), HasSubstr("by log4cpp"));
        EXPECT_THAT(file(), Not(HasSubstr("event 0")));
        std::filesystem::remove(directory_ / "text.log");
        std::filesystem::remove(directory_ / "events.log");
    }
}

TEST_F(LoggingInDeployer, AWrongPropertyFileIsAnError) {
    directory_.write("bad.properties", "log4cpp.rootCategory=LOUD, text\n");
    const Outcome bad = run(deployer({"--log4cpp-config", "bad.properties"}));
    EXPECT_EQ(255, bad.status);
    EXPECT_THAT(bad.err, HasSubstr("bad.properties: error: log4cpp cannot be configured: "));
    const Outcome none = run(deployer({"--log4cpp-config", "none.properties"}));
    EXPECT_EQ(255, none.status);
    EXPECT_THAT(none.err, HasSubstr("none.properties: error: log4cpp cannot be configured: No such file or directory"));
    const Outcome endless = run(deployer({"--log4cpp-config", "/dev/zero"}));
    EXPECT_EQ(255, endless.status);
    EXPECT_THAT(endless.err, HasSubstr("/dev/zero: error: log4cpp cannot be configured: it is not a regular file"));
    directory_.write("empty.xml", "<properties/>");
    const Outcome dry = run(deployer({"--dry-run", "-s", "empty.xml", "--log4cpp-config", "none.properties"}));
    EXPECT_EQ(255, dry.status);
    const Outcome empty = run(deployer({"--log4cpp-config="}));
    EXPECT_EQ(255, empty.status);
}

TEST_F(LoggingInDeployer, KilledLeavesWholeLines) {
    const std::string rolling =
        started("appender", "OCL::logging::RollingFileAppender",
                simple("Filename", "string", "events.log") + simple("LayoutName", "string", "pattern") +
                    simple("LayoutPattern", "string", "%m%n") + simple("MaxFileSize", "long", "20000") +
                    simple("MaxBackupIndex", "long", "9") + simple("MaxEventsPerCycle", "long", "0"));
    directory_.write("app.xml", application(rolling, -1));
    for (int round = 0; round < 6; ++round) {
        Command command = deployer({"-s", "app.xml"});
        command.inputStaysOpen = true;
        ChildProcess child(command);
        for (int i = 0; i < 1000 && !std::filesystem::exists(directory_ / "events.log.1"); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        std::this_thread::sleep_for(std::chrono::milliseconds(10 * round + 7));
        child.send(SIGKILL);
        EXPECT_EQ(128 + SIGKILL, child.finish().status);
        int files = 0;
        for (const auto& entry : std::filesystem::directory_iterator(directory_.path())) {
            const std::string name = entry.path().filename().string();
            if (name.find("events.log") != 0) continue;
            ++files;
            const std::string text = readFile(entry.path());
            if (text.empty()) continue;
            ASSERT_EQ('\n', text.back()) << name;
            for (const std::string& line : linesOf(text))
                ASSERT_THAT(line, testing::MatchesRegex("event [0-9]+|by log4cpp")) << name;
            if (name != "events.log") {
                EXPECT_GE(text.size(), 20000u) << name;
            }
            std::filesystem::remove(entry.path());
        }
        EXPECT_LT(1, files);
    }
}

}  // namespace
