// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// deployer --replay, as users call it: what was recorded comes again, and the same each time.
#include "replay_program.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>
#include <utility>

namespace replay_test {

using namespace oroforge::test;

const char* const kCamera = R"(
  <struct name="camera" type="replaytest::Camera">
    <struct name="Activity" type="Activity">
      <simple name="Period" type="double"><value>0.01</value></simple>
      <simple name="Priority" type="short"><value>0</value></simple>
      <simple name="Scheduler" type="string"><value>ORO_SCHED_OTHER</value></simple>
    </struct>
    <struct name="Properties" type="PropertyBag">
      <simple name="exposure" type="double"><value>3</value></simple>
    </struct>
    <struct name="Ports" type="PropertyBag">
      <simple name="image" type="string"><value>images</value></simple>
      <simple name="pose" type="string"><value>poses</value></simple>
      <simple name="debug.level" type="string"><value>levels</value></simple>
    </struct>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>)";

const char* const kViewer = R"(
  <struct name="images" type="ConnPolicy">
    <simple name="type" type="short"><value>1</value></simple>
    <simple name="size" type="short"><value>10</value></simple>
  </struct>
  <struct name="viewer" type="replaytest::Viewer">
    <struct name="Properties" type="PropertyBag">
      <simple name="factor" type="double"><value>2</value></simple>
    </struct>
    <struct name="Ports" type="PropertyBag">
      <simple name="image" type="string"><value>images</value></simple>
      <simple name="pose" type="string"><value>poses</value></simple>
      <simple name="level" type="string"><value>levels</value></simple>
    </struct>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>)";

namespace {

const char* const kRecorder = R"(
  <struct name="recorder" type="OCL::McapReporting">
    <struct name="Properties" type="PropertyBag">
      <simple name="ReportFile" type="string"><value>run.mcap</value></simple>
      <struct name="ReportData" type="PropertyBag">
        <simple name="Port" type="string"><value>camera.image</value></simple>
        <simple name="Port" type="string"><value>camera.pose</value></simple>
        <simple name="Port" type="string"><value>camera.debug.level</value></simple>
        <simple name="Component" type="string"><value>viewer</value></simple>
      </struct>
    </struct>
    <struct name="Peers" type="PropertyBag">
      <simple type="string"><value>camera</value></simple>
      <simple type="string"><value>viewer</value></simple>
    </struct>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>)";

}  // namespace

std::string ReplayInDirectory::recording_;

std::string deployment(const std::string& components) {
    std::string text = "<?xml version=\"1.0\"?>\n<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n<properties>\n";
    for (const char* package : {"ocl", "poses", "camera", "control"})
        text += std::string("<simple name=\"Import\" type=\"string\"><value>") + package + "</value></simple>\n";
    return text + components + "\n</properties>\n";
}

std::string component(const std::string& name, const std::string& type, const std::string& parts) {
    return "<struct name=\"" + name + "\" type=\"" + type + "\">" + parts +
           "<simple name=\"AutoConf\" type=\"boolean\"><value>1</value></simple>"
           "<simple name=\"AutoStart\" type=\"boolean\"><value>1</value></simple></struct>";
}

void ReplayInDirectory::SetUpTestSuite() {
    if (!recording_.empty()) return;
    const TempDir directory;
    directory.write("app.xml", deployment(std::string(kViewer) + kRecorder + kCamera));
    directory.write("wait.ops", "loadService(\"Deployer\", \"os\"); os.millisleep(400)\n");
    Command record;
    record.program = RTTSCRIPT_PROGRAM;
    record.arguments = {"-s", "app.xml", "-s", "wait.ops"};
    record.directory = directory.path();
    record.environment = {{"RTT_COMPONENT_PATH", REPLAY_TEST_PATH "/recorded:" REPLAY_TEST_PATH
                                                                  "/runs:" REPLAY_TEST_PATH "/types:" OCL_TEST_PATH},
                          {"ORO_LOGFILE", "orocos.log"}};
    const Outcome outcome = run(record);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    recording_ = readFile(directory / "run.mcap");
}

void ReplayInDirectory::SetUp() {
    directory_.write("run.mcap", recording_);
    directory_.write("app.xml", deployment(std::string(kViewer) + kRecorder + kCamera));
}

Command ReplayInDirectory::command(const std::vector<std::string>& words,
                                   const std::vector<std::string>& packages) const {
    Command result;
    result.program = DEPLOYER_PROGRAM;
    result.arguments = words;
    result.directory = directory_.path();
    std::string path;
    for (const std::string& package : packages) path += std::string(REPLAY_TEST_PATH "/") + package + ":";
    result.environment = {
        {"RTT_COMPONENT_PATH", path + OCL_TEST_PATH}, {"ORO_LOGFILE", "orocos.log"}, {"ORO_LOGLEVEL", "5"}};
    result.timeout = std::chrono::seconds(30);
    return result;
}

Outcome ReplayInDirectory::replay(std::vector<std::string> words, const std::vector<std::string>& packages) const {
    words.insert(words.begin(), {"--no-consolelog", "--replay", "run.mcap"});
    return run(command(words, packages));
}

namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ReplayProgram : public ReplayInDirectory {};

TEST_F(ReplayProgram, GivesTheSameBytesEachTimeWithoutTheLibraryOfWhatIsReplaced) {
    const std::string before = bytes("run.mcap");
    const Outcome one = replay({"--record", "one.mcap", "-s", "app.xml"});
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_THAT(one.out, ContainsRegex("^replayed run.mcap: [0-9]+ messages; 0.[0-9]+ s of simulated time in "
                                       "[0-9.]+ s \\([0-9.]+ times real time\\)\n$"));
    EXPECT_THAT(log(), HasSubstr("component 'camera' is not created: the recording has its ports"));
    EXPECT_THAT(log(), HasSubstr("component 'recorder' is not created: a replay records by --record"));
    EXPECT_THAT(log(), HasSubstr("created component 'viewer'"));
    // The recorder of the deployment does not write over the file that is replayed.
    EXPECT_EQ(bytes("run.mcap"), before);

    Command again = command({"-c", "0", DEPLOYER_PROGRAM, "--no-consolelog", "--replay", "run.mcap", "--record",
                             "two.mcap", "-s", "app.xml"});
    again.program = "taskset";
    EXPECT_EQ(run(again).status, 0);
    const std::string first = bytes("one.mcap");
    EXPECT_GT(first.size(), 1000U);
    EXPECT_TRUE(first == bytes("two.mcap"));
    EXPECT_THAT(first, Not(HasSubstr(directory_.path().filename().string())));
}

TEST_F(ReplayProgram, LibrariesThatAreMissingAreWarningsUnlessAComponentNeedsThem) {
    const Outcome outcome = replay({"-s", "app.xml"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, HasSubstr("warning: [DEP030] could not import 'camera'"));
    EXPECT_THAT(outcome.err, HasSubstr("the replay goes on without it"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("error:")));
    const Outcome lacking = replay({"-s", "app.xml"}, {"types"});
    EXPECT_EQ(lacking.status, 255);
    EXPECT_THAT(lacking.err, HasSubstr("error: [DEP031] unknown component type 'replaytest::Viewer'"));
}

TEST_F(ReplayProgram, AChangedValueChangesWhatIsSent) {
    EXPECT_EQ(replay({"--record", "one.mcap", "-s", "app.xml"}).status, 0);
    std::string text = bytes("app.xml");
    const std::string factor = "name=\"factor\" type=\"double\"><value>2";
    text.replace(text.find(factor), factor.size(), "name=\"factor\" type=\"double\"><value>4");
    directory_.write("app.xml", text);
    EXPECT_EQ(replay({"--record", "two.mcap", "-s", "app.xml"}).status, 0);
    EXPECT_FALSE(bytes("one.mcap") == bytes("two.mcap"));
}

TEST_F(ReplayProgram, ComponentsWithAPeriodRunUntilTheRecordingEnds) {
    directory_.write("app.xml", deployment(component("ticker", "replaytest::Ticker")));
    const Outcome outcome = replay({"--record", "one.mcap", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(replay({"--record", "two.mcap", "-s", "app.xml"}).status, 0);
    EXPECT_TRUE(bytes("one.mcap") == bytes("two.mcap"));
    EXPECT_THAT(bytes("one.mcap"), HasSubstr("/ticker/tick"));
}

TEST_F(ReplayProgram, ScriptsFindWhatIsReplaced) {
    directory_.write("app.ops",
                     "import(\"poses\")\nimport(\"control\")\n"
                     "loadComponent(\"viewer\", \"replaytest::Viewer\")\n"
                     "loadComponent(\"camera\", \"replaytest::Camera\")\n"
                     "var ConnPolicy cp\ncp.type = BUFFER\ncp.size = 10\n"
                     "connect(\"camera.image\", \"viewer.image\", cp)\n"
                     "connect(\"camera.debug.level\", \"viewer.level\", cp)\n"
                     "viewer.start()\ncamera.start()\n");
    const Outcome outcome = replay({"--record", "one.mcap", "-s", "app.ops"}, {"recorded", "runs", "types"});
    EXPECT_EQ(outcome.status, 0) << outcome.err << log();
    EXPECT_THAT(log(), HasSubstr("component 'camera' is not created: the recording has its ports"));
    EXPECT_THAT(bytes("one.mcap"), HasSubstr("/viewer/seen"));
}

#ifdef RTTLUA_PROGRAM
TEST_F(ReplayProgram, LuaScriptsDeployWhatIsReplayed) {
    directory_.write("app.lua",
                     "local d = rtt.getTC():getPeer('Deployer')\n"
                     "d:import('ocl') d:import('poses') d:import('control')\n"
                     "d:loadComponent('viewer', 'replaytest::Viewer')\n"
                     "d:loadComponent('camera', 'replaytest::Camera')\n"
                     "local policy = rtt.Variable.new('ConnPolicy')\n"
                     "assert(d:connect('camera.image', 'viewer.image', policy))\n"
                     "local viewer = d:getPeer('viewer')\n"
                     "assert(viewer:start())\n"
                     "print('deployed', ...)\n");
    const auto replayed = [this](std::vector<std::string> words) {
        words.insert(words.begin(), {"--replay", "run.mcap"});
        Command lua = command(words);
        lua.program = RTTLUA_PROGRAM;
        return run(lua);
    };
    for (const char* file : {"one.mcap", "two.mcap"}) {
        const Outcome outcome = replayed({"--record", file, "app.lua", "--replay", "is for the script"});
        EXPECT_EQ(outcome.status, 0) << outcome.err << log();
        EXPECT_THAT(outcome.out, ContainsRegex("^deployed\t--replay\tis for the script\nreplayed run.mcap: "));
        EXPECT_THAT(log(), HasSubstr("component 'camera' is not created: the recording has its ports"));
    }
    EXPECT_THAT(bytes("one.mcap"), HasSubstr("/viewer/seen"));
    EXPECT_TRUE(bytes("one.mcap") == bytes("two.mcap"));

    EXPECT_THAT(replayed({"--replace=cmera", "app.lua"}).err, HasSubstr("[RPL012] the recording has no component"));
    EXPECT_THAT(replayed({"--record"}).err, HasSubstr("rttlua: option '--record' takes a word"));
    const Outcome fails = replayed({"-e", "error('not deployed')"});
    EXPECT_EQ(fails.status, 1);
    EXPECT_THAT(fails.out, Not(HasSubstr("replayed")));
#ifdef HAS_RT_CHECK
    const Outcome checked = replayed({"--replay-check", "app.lua"});
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_THAT(checked.err, HasSubstr("--replay-check: 0 findings in "));
#endif
}
#endif

TEST_F(ReplayProgram, WhatIsReplacedMayBeNamed) {
    const char* const packages[] = {"recorded", "runs", "types"};
    const std::vector<std::string> all(std::begin(packages), std::end(packages));
    ASSERT_EQ(replay({"--replace", "viewer", "--record", "one.mcap", "-s", "app.xml"}, all).status, 0) << log();
    EXPECT_THAT(log(), HasSubstr("component 'camera' runs, it is not replayed: --replace does not name it"));
    EXPECT_THAT(log(), HasSubstr("component 'viewer' is not created: the recording has its ports"));
    EXPECT_THAT(bytes("one.mcap"), HasSubstr("/camera/image"));
    directory_.write("app.ops",
                     "import(\"poses\")\nimport(\"control\")\n"
                     "loadComponent(\"viewer\", \"replaytest::Viewer\")\nviewer.start()\n");
    const Outcome itself = replay({"-s", "app.ops"}, all);
    EXPECT_EQ(itself.status, 0);
    EXPECT_THAT(itself.err, HasSubstr("run.mcap: warning: [RPL013] nothing of the recording was replayed"));
    EXPECT_THAT(log(), HasSubstr("component 'viewer' runs, it is not replayed: it has an input; --replace=viewer"));
    const Outcome named = replay({"--replace=viewer", "-s", "app.ops"}, all);
    EXPECT_EQ(named.status, 0);
    EXPECT_THAT(named.err, Not(HasSubstr("RPL013")));
}

TEST_F(ReplayProgram, AScriptThatWaitsForASignalLetsTheReplayBegin) {
    directory_.write("wait.ops", "waitForInterrupt()\n");
    const Outcome outcome = replay({"-s", "app.xml", "-s", "wait.ops"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, HasSubstr("replayed run.mcap: "));
}

TEST_F(ReplayProgram, TheLogDoesNotTellHowFastTheComputerIs) {
    const auto lines = [this] {
        std::filesystem::remove(directory_ / "orocos.log");
        EXPECT_EQ(replay({"-s", "app.xml"}).status, 0);
        return log();
    };
    const std::string first = lines();
    EXPECT_EQ(first, lines());
    EXPECT_THAT(first, HasSubstr("0.000 ["));
}

TEST_F(ReplayProgram, ASignalEndsItInOrder) {
    Command slow = command({"--replay", "run.mcap", "--replay-speed", "0.001", "--record", "one.mcap", "-s", "app.xml",
                            "--log-level", "Info"});
    ChildProcess child(slow);
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    const auto hasBegun = [this] {
        return std::filesystem::exists(directory_ / "orocos.log") &&
               log().find("created thread 'replay.recorder.Writer'") != std::string::npos;
    };
    while (!hasBegun() && std::chrono::steady_clock::now() < limit)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    child.send(SIGTERM);
    const Outcome outcome = child.finish();
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("replayed, not to the end, run.mcap: "));
}

TEST_F(ReplayProgram, TheSpeedIsThatOfTheOption) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(replay({"--replay-speed", "1", "-s", "app.xml"}).status, 0);
    EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(250));
}

}  // namespace
}  // namespace replay_test
