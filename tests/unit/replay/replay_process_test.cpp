// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A deployment with a replay: its ports are connected by the file, as they appear when it is configured.
#include "replay_fixture.hpp"

#include <support/child_process.hpp>

#include <chrono>

namespace {

using namespace replay_test;
using namespace oroforge::test;
using testing::HasSubstr;

std::string simple(const std::string& name, const std::string& type, const std::string& value) {
    return "<simple name='" + name + "' type='" + type + "'><value>" + value + "</value></simple>";
}
std::string bag(const std::string& name, const std::string& content) {
    return "<struct name='" + name + "' type='PropertyBag'>" + content + "</struct>";
}
const std::string kConfigured = simple("AutoConf", "boolean", "1"), kStarted = simple("AutoStart", "boolean", "1");

class ReplayProcess : public Replay {
protected:
    Outcome deploy(const std::string& replayProperties) {
        const std::string reported = simple("Port", "string", "replay.talker.text");
        directory.write(
            "app.xml", "<properties>" + simple("Import", "string", "ocl") + "<struct name='text' type='ConnPolicy'>" +
                           simple("type", "short", "1") + simple("size", "short", "100") +
                           "</struct><struct name='hello' type='OCL::HelloWorld'>" +
                           bag("Ports", simple("the_buffer_port", "string", "text")) + kConfigured + kStarted +
                           "</struct><struct name='replay' type='OCL::McapReplay'>" +
                           bag("Ports", simple("talker.text", "string", "text")) +
                           bag("Properties", simple("ReplayFile", "string", "in.mcap") + replayProperties) +
                           kConfigured + "</struct><struct name='recorder' type='OCL::McapReporting'>" +
                           bag("Peers", simple("", "string", "replay")) +
                           bag("Properties", simple("ReportFile", "string", "out.mcap") + bag("ReportData", reported)) +
                           kConfigured + kStarted + "</struct></properties>");
        directory.write("wait.ops",
                        "var int i = 0\nloadService(\"Deployer\", \"os\")\nreplay.start()\n"
                        "while i < 100 && replay.isRunning() { os.millisleep(50); set i = i + 1 }\n");
        Command command;
        command.program = RTTSCRIPT_PROGRAM;
        command.arguments = {"-s", "app.xml", "-s", "wait.ops"};
        command.directory = directory.path();
        command.environment = {{"RTT_COMPONENT_PATH", OCL_TEST_PATH}, {"ORO_LOGLEVEL", "6"}, {"OROCOS_TARGET", TARGET}};
        command.timeout = std::chrono::seconds(40);
        return run(command);
    }
    void writeTexts() {
        OtherFile other;
        const auto text = other.topic("/talker/text", "std_msgs/msg/String", "string data\n");
        for (std::uint64_t i = 0; i != 20; ++i)
            other.message(text, 1000000000 + i * 10000000, Cdr().put("sentence " + std::to_string(i)));
        write("in.mcap", other);
    }
};

TEST_F(ReplayProcess, IsConnectedByItsDeployment) {
    writeTexts();
    const Outcome outcome = deploy("");
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("Received sentence 0"));  // by hello
    const auto again = open("out.mcap");
    ASSERT_TRUE(again) << error;
    EXPECT_EQ("replay:talker.text", again->topics().at(0).component + ":" + again->topics().at(0).port);
    Reader<std::string> texts(port(*again, "/replay/talker/text"));
    const std::vector<RTT::nsecs> times = play(*again);
    std::vector<std::string> expected;
    for (int i = 0; i != 20; ++i) expected.push_back("sentence " + std::to_string(i));
    EXPECT_EQ(expected, texts.all());
    ASSERT_FALSE(times.empty());
    EXPECT_GT(times.back() - times.front(), 10000000);  // 190 ms, but for a first one that came late
}

TEST_F(ReplayProcess, SaysWhyItIsNotConfigured) {
    writeTexts();
    const Outcome outcome = deploy(simple("Topics", "string", "/talker/tex"));
    EXPECT_NE(0, outcome.status);
    EXPECT_THAT(outcome.err,
                HasSubstr("'replay' is not configured: in.mcap: error: [MCP027] property Topics: no port of "
                          "the recording matches '/talker/tex'; did you mean '/talker/text'?"));
    EXPECT_THAT(outcome.err, HasSubstr("error: [DEP050] could not configure component 'replay'"));
}

}  // namespace
