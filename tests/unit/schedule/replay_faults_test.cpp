// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// deployer --replay with what it cannot replay: each is an error that says what to do.
#include "replay_program.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace replay_test {
namespace {

using namespace oroforge::test;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ReplayFaults : public ReplayInDirectory {
protected:
    Outcome start(const std::vector<std::string>& words) { return run(command(words)); }
};

TEST_F(ReplayFaults, OptionsThatNeedAReplay) {
    for (const auto& words : std::vector<std::vector<std::string>>{{"--record", "one.mcap"},
                                                                   {"--replace", "camera"},
                                                                   {"--tolerate"},
                                                                   {"--replay-speed", "2"},
                                                                   {"--replay-check"}}) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"-s", "app.xml"});
        const Outcome outcome = start(all);
        EXPECT_EQ(outcome.status, 255);
        EXPECT_THAT(outcome.err, HasSubstr(words.front() + " is of no use without --replay"));
    }
}

TEST_F(ReplayFaults, OptionsThatExcludeAReplay) {
    EXPECT_THAT(start({"--replay", "run.mcap", "--check", "-s", "app.xml"}).err,
                HasSubstr("--replay executes components, which --check and --dry-run do not start"));
    EXPECT_THAT(start({"--replay", "run.mcap", "--rt-check", "-s", "app.xml"}).err, HasSubstr("--rt-check watches"));
    EXPECT_THAT(start({"--replay", "", "-s", "app.xml"}).err, HasSubstr("the name of the file of --replay is empty"));
    for (const char* speed : {"0", "-1", "fast", "nan", "1x"})
        EXPECT_THAT(start({"--replay", "run.mcap", "--replay-speed", speed, "-s", "app.xml"}).err,
                    HasSubstr("no speed: '" + std::string(speed) + "'"));
}

TEST_F(ReplayFaults, AFileThatIsNotThere) {
    const Outcome outcome = start({"--replay", "none.mcap", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("none.mcap: error: [MCP010]"));
}

TEST_F(ReplayFaults, AFileThatIsNoRecording) {
    directory_.write("run.mcap", "this is a text, and longer than the mark at the beginning of a recording");
    const Outcome outcome = replay({"-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("run.mcap: byte 0: error: [MCP001]"));
}

TEST_F(ReplayFaults, WhatIsWholeOfATruncatedFileIsReplayedAndTheRestReported) {
    std::string text = bytes("run.mcap");
    text.resize(text.size() - 200);
    directory_.write("run.mcap", text);
    const Outcome outcome = replay({"-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("[MCP0"));
    EXPECT_THAT(outcome.out, HasSubstr("replayed run.mcap: "));
    directory_.write("run.mcap", text.substr(0, 300));
    const Outcome less = replay({"-s", "app.xml"});
    EXPECT_EQ(less.status, 255) << less.out;
    EXPECT_THAT(less.err, HasSubstr("run.mcap: "));
}

TEST_F(ReplayFaults, ATypeThatIsNotLoaded) {
    const Outcome outcome = replay({"-s", "app.xml"}, {});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("error: [DEP031] unknown component type 'replaytest::Viewer'"));
    directory_.write("app.xml", deployment(std::string(kViewer) + kCamera));
    const Outcome lacking = replay({"-s", "app.xml"}, {"runs"});
    EXPECT_EQ(lacking.status, 255);
    EXPECT_THAT(lacking.err, HasSubstr("error: [RPL006] port 'camera.pose' of the recording cannot be replayed: "));
    EXPECT_THAT(lacking.err, HasSubstr("MCP021"));
}

TEST_F(ReplayFaults, ATypeThatHasAnotherFieldNowUnlessThatIsTolerated) {
    const Outcome outcome = replay({"-s", "app.xml"}, {"changed"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("error: [RPL006] port 'camera.pose' of the recording cannot be replayed: "));
    EXPECT_THAT(outcome.err, HasSubstr("quality"));
    const Outcome tolerated = replay({"--tolerate", "--record", "one.mcap", "-s", "app.xml"}, {"changed"});
    EXPECT_EQ(tolerated.status, 0) << tolerated.err;
    EXPECT_THAT(bytes("one.mcap"), HasSubstr("/viewer/scaled"));
}

TEST_F(ReplayFaults, AComponentThatTriggersItselfForEver) {
    directory_.write("app.xml", deployment(component("restless", "replaytest::Restless")));
    const Outcome outcome = replay({"-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("error: [RPL002] the replay ends: component 'restless' triggers itself"));
}

TEST_F(ReplayFaults, AComponentThatWaitsWhileTimeStands) {
    directory_.write("app.xml", deployment(component("patient", "replaytest::Patient")));
    EXPECT_EQ(replay({"-s", "app.xml"}).status, 0);
    EXPECT_THAT(log(), HasSubstr("error: [RPL005] component 'patient', or a script, has been waiting for 5 s"));
}

TEST_F(ReplayFaults, ActivitiesThatAReplayCannotExecute) {
    directory_.write(
        "app.xml", deployment(component("loner", "replaytest::Loner") + component("reader", "replaytest::Restless", R"(
  <struct name="Activity" type="FileDescriptorActivity">
    <simple name="Period" type="double"><value>0</value></simple>
    <simple name="Priority" type="short"><value>0</value></simple>
    <simple name="Scheduler" type="string"><value>ORO_SCHED_OTHER</value></simple>
  </struct>)")));
    (void)replay({"-s", "app.xml"});
    EXPECT_THAT(log(), HasSubstr("warning: [RPL003] component 'loner'"));
    EXPECT_THAT(log(), HasSubstr("warning: [RPL004] component 'reader' waits for file descriptors"));
}

/** The deployer looks for its parts beside the runtime's library: here beside a copy. */
TEST_F(ReplayFaults, AToolchainWithoutThePartThatReadsRecordings) {
    namespace fs = std::filesystem;
    const fs::path copies = directory_ / "copies", part = copies / REPLAY_PART;
    fs::create_directories(part.parent_path());
    fs::copy_file(RUNTIME_LIBRARY, copies / RUNTIME_NAME);
    Command deployer = command({"--no-consolelog", "--replay", "run.mcap", "-s", "app.xml"});
    deployer.environment.emplace("LD_LIBRARY_PATH", copies.string());
    const auto error = [&] {
        const Outcome outcome = run(deployer);
        EXPECT_EQ(outcome.status, 255);
        return outcome.err;
    };
    EXPECT_THAT(error(), HasSubstr("--replay: error: [RPL001] this toolchain has no part that reads recordings, " +
                                   part.string() + "; it is made if libzstd-dev or liblz4-dev is installed"));
    directory_.write(fs::path("copies") / REPLAY_PART, "no library");
    EXPECT_THAT(error(), HasSubstr("--replay: error: [RPL001] the part that reads recordings cannot be used: "));
    fs::remove(part);
    fs::copy_file(OTHER_LIBRARY, part);
    EXPECT_THAT(error(), HasSubstr("is of another version"));
}

#ifdef HAS_RT_CHECK
TEST_F(ReplayFaults, WhatIsNotTheSameInEachReplayIsReportedIfAsked) {
    directory_.write("app.xml", deployment(component("worldly", "replaytest::Worldly") +
                                           component("messenger", "replaytest::Messenger")));
    EXPECT_EQ(replay({"-s", "app.xml"}).status, 0);
    const Outcome outcome = replay({"--replay-check", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("error: [RPL008] component 'worldly' reads a clock of the computer in "
                                       "updateHook(): clock_gettime(), 2 times"));
    EXPECT_THAT(outcome.err, HasSubstr("[RPL009] component 'worldly' waits in updateHook(): nanosleep(), 2 times"));
    EXPECT_THAT(outcome.err, HasSubstr("[RPL010] this line also begins a thread: pthread_create(), 2 times"));
    EXPECT_THAT(outcome.err, HasSubstr("[RPL011] component 'messenger' was triggered by other threads, 2 times"));
    EXPECT_THAT(outcome.err, HasSubstr("control.cpp:"));
}

TEST_F(ReplayFaults, RandomNumbersAndDevicesAreReportedIfAsked) {
    directory_.write("app.xml", deployment(component("gambler", "replaytest::Gambler")));
    const Outcome outcome = replay({"--replay-check", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255);
    for (const char* function : {"rand", "std::random_device", "getrandom", "fopen(64)?"})
        EXPECT_THAT(outcome.err, ContainsRegex("\\[RPL016\\] component 'gambler' takes random numbers in "
                                               "updateHook\\(\\): " +
                                               std::string(function) + "\\(\\), 1 time\n"));
    EXPECT_THAT(outcome.err,
                HasSubstr("[RPL017] component 'gambler' opens a device in configureHook(): open(), 1 time"));
    EXPECT_THAT(outcome.err, HasSubstr("--replay-check: 5 findings in "));  // not rand_r(), std::mt19937, /dev/null
}

TEST_F(ReplayFaults, WhatIsTheSameInEachReplayIsNotReported) {
    const Outcome outcome = replay({"--replay-check", "--record", "one.mcap", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("--replay-check: 0 findings in "));
}
#endif

TEST_F(ReplayFaults, TheRecordingItselfIsNotWrittenOver) {
    const std::string before = bytes("run.mcap");
    const Outcome outcome = replay({"--record", "./run.mcap", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("--record would write over the recording that is replayed"));
    EXPECT_EQ(bytes("run.mcap"), before);
}

TEST_F(ReplayFaults, AComponentThatIsNotInTheRecording) {
    const Outcome outcome = replay({"--replace", "camera,vewer", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("--replace: error: [RPL012] the recording has no component 'vewer'; did you "
                                       "mean 'viewer'?"));
    EXPECT_THAT(replay({"--replace", ",", "-s", "app.xml"}).err, HasSubstr("--replace names no component"));
}

TEST_F(ReplayFaults, AConnectedPortThatTheRecordingLacks) {
    std::string text = deployment(std::string(kCamera) + kViewer);
    const std::string port = "name=\"image\"";
    text.replace(text.find(port), port.size(), "name=\"imgae\"");  // that of the camera
    directory_.write("app.xml", text);
    const Outcome outcome = replay({"--replace", "camera", "-s", "app.xml"});
    EXPECT_THAT(outcome.err, ContainsRegex("app.xml:[0-9]+:[0-9]+: warning: \\[RPL014\\] the recording has no port "
                                           "'camera.imgae', so nothing comes from it in connection 'images'; did you "
                                           "mean 'image'\\?"));
    EXPECT_THAT(log(), HasSubstr("RPL014"));
    // Without the option, the component has to be made, and the reason is in the log.
    EXPECT_EQ(replay({"--log-level", "Info", "-s", "app.xml"}).status, 255);
    EXPECT_THAT(log(), HasSubstr("its port 'imgae' was not recorded; did you mean 'image'?"));
}

TEST_F(ReplayFaults, InputsOfWhatIsReplacedAreNotReported) {
    const Outcome outcome = replay({"--replace", "camera,viewer", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.err, Not(HasSubstr("RPL")));
    EXPECT_THAT(log(), HasSubstr("the recording has no port 'viewer.pose'"));
}

TEST_F(ReplayFaults, AComponentThatIsNotInTheDeploymentOrHasToRun) {
    directory_.write("app.xml", deployment(kCamera));
    const Outcome missing = replay({"--replace", "camera,viewer", "-s", "app.xml"});
    EXPECT_EQ(missing.status, 0) << missing.err;
    EXPECT_THAT(missing.err, HasSubstr("--replace: warning: [RPL015] the deployment has no component 'viewer', so "
                                       "nothing is replaced by what was recorded"));
    EXPECT_THAT(missing.err, Not(HasSubstr("no component 'camera'")));
    directory_.write("app.xml", deployment(component("viewer", "replaytest::Viewer") + R"(
  <struct name="slave" type="replaytest::Messenger">
    <struct name="Activity" type="SlaveActivity">
      <simple name="Master" type="string"><value>viewer</value></simple>
    </struct>
  </struct>)"));
    const Outcome master = replay({"--replace", "viewer", "-s", "app.xml"});
    EXPECT_THAT(master.err, ContainsRegex("app.xml:[0-9]+:[0-9]+: warning: \\[RPL015\\] component 'viewer' runs, "
                                          "--replace cannot replace it: it executes others"));
}

TEST_F(ReplayFaults, AFileThatCannotBeWritten) {
    const Outcome outcome = replay({"--record", "none/one.mcap", "-s", "app.xml"});
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("none/one.mcap: error: [RPL007]"));
}

}  // namespace
}  // namespace replay_test
