// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The deployment manual's application: a controller, a plant, and a reporter that senses what they exchange.
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;

class BigExample : public testing::Test {
protected:
    BigExample() { std::filesystem::copy(MANUAL_FILES, directory_.path()); }

    Outcome deploy(const std::vector<std::string>& arguments) {
        Command command;
        command.program = RTTSCRIPT_PROGRAM;
        command.arguments = arguments;
        command.directory = directory_.path();
        command.environment = {{"RTT_COMPONENT_PATH", MANUAL_COMPONENTS ":" BUILT_COMPONENTS}};
        command.timeout = std::chrono::seconds(60);
        return run(command);
    }

    TempDir directory_;
};

TEST_F(BigExample, RunsFromItsFiles) {
    // What a user types at the console, and when the loop is closed.
    directory_.write("session.ops",
                     "Recorder.start()\n"
                     "Loop.supervision.inState(\"Approaching\")\n"
                     "while (!Loop.supervision.inState(\"Holding\")) { yield }\n"
                     // The recorder gets the processor late where the machine is busy.
                     "var int n = 0\nwhile (n < 1000) { n = n + 1; yield }\n"
                     "Recorder.stop()\n");
    const Outcome outcome = deploy({"-linfo", "-s", "application.xml", "session.ops"});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    // Inline values first, then the files in their order.
    EXPECT_THAT(outcome.out, HasSubstr("Loop: K = 3.000000, Limit = 5.000000\n"));

    std::istringstream report(readFile(directory_ / "run.dat"));
    std::string header;
    ASSERT_TRUE(std::getline(report, header));
    EXPECT_EQ(" TimeStamp Loop.SteeringSignals Loop.K", header);
    double time = 0, signal = 0, gain = 0, last = -1, lastSignal = 0;
    int rows = 0;
    while (report >> time >> signal >> gain) {
        EXPECT_GE(time, last);
        EXPECT_EQ(3, gain);
        last = time;
        lastSignal = signal;
        ++rows;
    }
    EXPECT_TRUE(report.eof());
    EXPECT_GT(rows, 2);
    EXPECT_LT(lastSignal, 0.5) << "the controller calms down as the plant comes near";
    // AutoSave: the reporter's own properties have been added to what its file had.
    EXPECT_THAT(readFile(directory_ / "recorder.cpf"), HasSubstr("WriteHeader"));
    EXPECT_THAT(readFile(directory_ / "loop-opts.cpf"), Not(HasSubstr("Limit")));
}

TEST_F(BigExample, IsAcceptedByEachLevelOfChecks) {
    EXPECT_EQ(0, deploy({"--dry-run", "-s", "application.xml"}).status);
    EXPECT_EQ(0, deploy({"--check", "-s", "application.xml"}).status);
}

TEST_F(BigExample, AnIncludedPartIsAsIfItStoodThere) {
    std::string text = readFile(directory_ / "application.xml");
    const std::size_t begin = text.find("  <struct name=\"Motor\""), end = text.rfind("</properties>");
    directory_.write("motor.xml", "<properties>\n" + text.substr(begin, end - begin) + "</properties>\n");
    text.replace(begin, end - begin, "  <simple name=\"Include\" type=\"string\"><value>motor.xml</value></simple>\n");
    directory_.write("application.xml", text);
    const Outcome outcome = deploy({"--check", "-s", "application.xml"});
    EXPECT_EQ(0, outcome.status) << outcome.err;
}

TEST_F(BigExample, AScriptCanBeRunByASmallFileForTheDeployerItself) {
    directory_.write("scriptfile.ops",
                     "import(\"cell\")\n"
                     "loadComponent(\"Loop\", \"cell::Controller\")\n"
                     "loadComponent(\"Motor\", \"cell::Plant\")\n"
                     "var ConnPolicy cp\n"
                     "cp.type = BUFFER\n"
                     "cp.size = 10 // samples\n"
                     "connect(\"Motor.Position\", \"Loop.SensorValues\", cp )\n"
                     "loadService(\"Loop\", \"marshalling\")\n"
                     "Loop.marshalling.readProperties(\"loop-main.cpf\")\n"
                     "Loop.configure()\n");
    directory_.write("deploy.xml",
                     "<properties>\n"
                     "  <struct name=\"Deployer\" type=\"PropertyBag\">\n"
                     "    <struct name=\"Activity\" type=\"Activity\">\n"
                     "      <simple name=\"Period\" type=\"double\"><value>0.01</value></simple>\n"
                     "    </struct>\n"
                     "    <simple name=\"RunScript\" type=\"string\"><value>scriptfile.ops</value></simple>\n"
                     "  </struct>\n"
                     "</properties>\n");
    const Outcome outcome = deploy({"-s", "deploy.xml"});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("Loop: K = 2.000000, Limit = 5.000000\n"));
}

}  // namespace
