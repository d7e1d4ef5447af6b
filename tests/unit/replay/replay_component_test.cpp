// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component that replays: its ports, its time and its errors.
#include "replay_fixture.hpp"

#include <ocl/McapReplay.hpp>
#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>

#include <chrono>
#include <thread>

namespace {

using namespace replay_test;
using mcap_test::LogText;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ReplayComponent : public Replay {
protected:
    void SetUp() override {
        Replay::SetUp();
        replay.reset(new OCL::McapReplay("replay"));
        replay->setActivity(new RTT::extras::SlaveActivity(0.01));
        give<std::string>("ReplayFile", file("run.mcap"));
    }
    void TearDown() override {
        replay.reset();
        Replay::TearDown();
    }
    /** Ten samples of `speed`, 10 ms apart, and one of `motor.current` after the fifth. */
    void record() {
        ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->reportPort("Machine", "motor.current"));
        ASSERT_TRUE(recorder->start());
        for (int i = 0; i != 10; ++i) {
            machine.speed.write(i);
            if (i == 4) machine.current.write(0.5F);
            step();
        }
        recorder->stop();
    }
    template <class T>
    void give(const std::string& name, const T& value) {
        auto* const found = dynamic_cast<RTT::Property<T>*>(replay->getProperty(name));
        ASSERT_TRUE(found) << name;
        found->set(value);
    }
    template <class T>
    T attribute(const std::string& name) {
        return types_test::valueOf<T>(replay->getAttribute(name)->getDataSource());
    }
    RTT::base::PortInterface* speedPort() {
        return replay->provides()->hasService("Machine") ? replay->provides("Machine")->getPort("speed") : nullptr;
    }
    void cycle(double seconds = 0.01) {
        RTT::os::TimeService::Instance()->secondsChange(seconds);
        replay->update();
    }
    /** Why it is not configured. */
    std::string refusal() {
        const LogText log;
        EXPECT_FALSE(replay->configure());
        EXPECT_FALSE(replay->provides()->hasService("Machine"));
        return log();
    }

    std::unique_ptr<OCL::McapReplay> replay;
};

TEST_F(ReplayComponent, WritesEachSampleWhenItsTimeHasCome) {
    record();
    EXPECT_FALSE(replay->start());
    ASSERT_TRUE(replay->configure());
    EXPECT_NEAR(0.09, attribute<double>("Duration"), 1e-9);
    Reader<double> speeds(speedPort());
    Reader<float> currents(replay->provides("Machine")->provides("motor")->getPort("current"));
    ASSERT_TRUE(replay->start());
    replay->update();
    EXPECT_THAT(speeds.all(), ElementsAre(0));
    cycle();
    EXPECT_THAT(speeds.all(), ElementsAre(1));
    cycle(0.005);
    EXPECT_THAT(speeds.all(), IsEmpty());
    cycle(0.035);  // it is late, and catches up
    EXPECT_THAT(speeds.all(), ElementsAre(2, 3, 4, 5));
    EXPECT_THAT(currents.all(), ElementsAre(0.5F));
    EXPECT_NEAR(0.05, attribute<double>("Time"), 1e-9);
    EXPECT_EQ(7U, attribute<unsigned int>("Samples"));
    cycle(1);
    EXPECT_THAT(speeds.all(), ElementsAre(6, 7, 8, 9));
    EXPECT_FALSE(replay->isRunning());
    ASSERT_TRUE(replay->start());  // from the beginning
    replay->update();
    EXPECT_THAT(speeds.all(), ElementsAre(0));
}

TEST_F(ReplayComponent, HasASpeedThatMayChange) {
    record();
    give("Speed", 2.0);
    ASSERT_TRUE(replay->configure());
    Reader<double> speeds(speedPort());
    ASSERT_TRUE(replay->start());
    cycle();
    EXPECT_THAT(speeds.all(), ElementsAre(0, 1, 2));
    give("Speed", 0.5);
    replay->update();
    cycle(0.02);
    EXPECT_THAT(speeds.all(), ElementsAre(3));
    {
        const LogText log;
        give("Speed", -1.0);
        cycle(0.02);
        EXPECT_THAT(log(), HasSubstr("'replay' keeps its speed: error: [MCP027] property Speed: found -1"));
        EXPECT_THAT(speeds.all(), ElementsAre(4));
    }
    give("Speed", 0.0);
    replay->update();
    EXPECT_THAT(speeds.all(), ElementsAre(5, 6, 7, 8, 9));
    EXPECT_FALSE(replay->isRunning());
}

TEST_F(ReplayComponent, RepeatsAPartOfTheRecordingInALoop) {
    record();
    give("Start", 0.02);
    give("End", 0.04);
    give("Loop", true);
    ASSERT_TRUE(replay->configure());
    Reader<double> speeds(speedPort());
    ASSERT_TRUE(replay->start());
    replay->update();
    for (int i = 0; i != 3; ++i) cycle();
    EXPECT_THAT(speeds.all(), ElementsAre(2, 3, 2, 3, 2, 3, 2));
    EXPECT_TRUE(replay->isRunning());
    EXPECT_EQ(3U, attribute<unsigned int>("Rounds"));
    EXPECT_TRUE(replay->stop());
}

TEST_F(ReplayComponent, LoopsOverOneTimeWithoutSpinning) {
    record();
    give("Start", 0.035);
    give("End", 0.045);
    give("Loop", true);
    ASSERT_TRUE(replay->configure());
    Reader<double> speeds(speedPort());
    ASSERT_TRUE(replay->start());
    for (int i = 0; i != 10; ++i) cycle(0.001);
    EXPECT_LE(speeds.all().size(), 2U);
    EXPECT_TRUE(replay->isRunning());
}

TEST_F(ReplayComponent, SeeksPausesAndSteps) {
    record();
    EXPECT_FALSE(replay->seek(0.05));
    ASSERT_TRUE(replay->configure());
    EXPECT_FALSE(replay->pause() || replay->resume() || replay->step());
    for (const double wrong : {-0.01, 0.1, std::numeric_limits<double>::quiet_NaN()}) EXPECT_FALSE(replay->seek(wrong));
    Reader<double> speeds(speedPort());
    EXPECT_TRUE(replay->seek(0.06));
    ASSERT_TRUE(replay->start());
    replay->update();
    EXPECT_THAT(speeds.all(), ElementsAre(6));
    EXPECT_TRUE(replay->seek(0.02));
    cycle();
    EXPECT_THAT(speeds.all(), ElementsAre(2, 3));
    EXPECT_FALSE(replay->step());
    EXPECT_TRUE(replay->pause());
    cycle(10);
    EXPECT_THAT(speeds.all(), IsEmpty());
    RTT::OperationCaller<bool()> step = replay->getOperation("step");
    EXPECT_TRUE(step());
    replay->update();
    EXPECT_THAT(speeds.all(), ElementsAre(4));
    cycle(10);
    EXPECT_THAT(speeds.all(), IsEmpty());
    EXPECT_TRUE(replay->resume());
    EXPECT_FALSE(replay->resume());
    cycle(0.02);
    EXPECT_THAT(speeds.all(), ElementsAre(5, 6));
}

TEST_F(ReplayComponent, ReplaysTheTopicsThatArePatterns) {
    record();
    give<std::string>("Topics", "/Machine/sp*, /nothing/like/it");
    EXPECT_THAT(refusal(), HasSubstr("'replay' is not configured: " + file("run.mcap") +
                                     ": error: [MCP027] property Topics: no port of the recording matches "
                                     "'/nothing/like/it'"));
    give<std::string>("Topics", "/Machine/speeds");
    EXPECT_THAT(refusal(), HasSubstr("did you mean '/Machine/speed'?"));
    give<std::string>("Topics", "/Machine/m*");
    ASSERT_TRUE(replay->configure());
    EXPECT_FALSE(speedPort());
    EXPECT_TRUE(replay->provides("Machine")->provides("motor")->getPort("current"));
    ASSERT_TRUE(replay->start());
    replay->update();
    EXPECT_EQ(0U, attribute<unsigned int>("Samples"));
    cycle(0.04);
    EXPECT_EQ(1U, attribute<unsigned int>("Samples"));
    EXPECT_FALSE(replay->isRunning());
}

TEST_F(ReplayComponent, RefusesWrongProperties) {
    record();
    for (const auto& [property, value] : {std::pair<const char*, double>{"Speed", -1},
                                          {"Speed", std::numeric_limits<double>::quiet_NaN()},
                                          {"Speed", 1e9},
                                          {"Start", -1},
                                          {"Start", 0.2},
                                          {"End", -1}}) {
        give(property, value);
        EXPECT_THAT(refusal(), HasSubstr(std::string("[MCP027] property ") + property + ": found "));
        give(property, *property == 'S' && property[1] == 'p' ? 1.0 : 0.0);
    }
    give<std::string>("ReplayFile", file("none.mcap"));
    EXPECT_THAT(refusal(), HasSubstr("none.mcap: error: [MCP010] the recording cannot be read"));
    give<std::string>("ReplayFile", file("run.mcap"));
    EXPECT_TRUE(replay->configure());
    give("Start", 0.2);
    EXPECT_FALSE(replay->start());
}

TEST_F(ReplayComponent, NamesEveryTopicThatHasNoPort) {
    OtherFile other;
    (void)other.topic("/a", "tank/msg/Unknown", "float64 x\n");
    (void)other.topic("/place", "sample/msg/Point", "float64 x\n");
    (void)other.topic("/Machine/speed", "std_msgs/msg/Float64", "float64 data\n");
    (void)other.topic("Machine/speed", "std_msgs/msg/Float64", "float64 data\n");
    write("run.mcap", other);
    const std::string text = refusal();
    EXPECT_THAT(text, HasSubstr("run.mcap: error: [MCP021] topic '/a': its type 'tank/msg/Unknown' is not loaded"));
    EXPECT_THAT(text, HasSubstr("error: [MCP023] topic '/place': the loaded type '/sample/Point'"));
    EXPECT_THAT(text,
                HasSubstr("error: [MCP020] topic 'Machine/speed': there is a port 'speed' in the service 'Machine' "
                          "already"));
    give<std::string>("Topics", "/place /Machine/*");
    give("Tolerate", true);
    const LogText log;
    ASSERT_TRUE(replay->configure());
    EXPECT_THAT(log(), HasSubstr("[MCP024] topic '/place'"));
    EXPECT_TRUE(speedPort());
    EXPECT_TRUE(replay->getPort("place"));
}

TEST_F(ReplayComponent, RemovesItsPortsAtCleanup) {
    record();
    for (int round = 0; round != 3; ++round) {
        ASSERT_TRUE(replay->configure());
        RTT::InputPort<double> reader("reader");
        ASSERT_TRUE(speedPort()->connectTo(&reader));
        ASSERT_TRUE(replay->start());
        replay->update();
        ASSERT_TRUE(replay->stop() && replay->cleanup());
        EXPECT_FALSE(replay->provides()->hasService("Machine"));
        EXPECT_FALSE(reader.connected());
    }
    ASSERT_TRUE(replay->configure());
    RTT::InputPort<double> reader("reader");
    ASSERT_TRUE(speedPort()->connectTo(&reader));
    ASSERT_TRUE(replay->start());
    replay.reset();  // while it runs
    EXPECT_FALSE(reader.connected());
}

TEST_F(ReplayComponent, WithoutAPeriodIsWokenForEachSample) {
    record();
    RTT::os::TimeService::Instance()->enableSystemClock(true);
    for (const bool hasThread : {true, false}) {
        if (hasThread)
            replay->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0));
        else
            replay->setActivity(new RTT::extras::SequentialActivity());
        ASSERT_TRUE(replay->configure());
        Reader<double> speeds(speedPort());
        const auto begin = std::chrono::steady_clock::now();
        ASSERT_TRUE(replay->start());
        while (replay->isRunning() && std::chrono::steady_clock::now() - begin < std::chrono::seconds(5))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_FALSE(replay->isRunning());
        EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(85));
        EXPECT_THAT(speeds.all(), SizeIs(10));
        ASSERT_TRUE(replay->cleanup());
    }
}

TEST_F(ReplayComponent, IsWokenByItsOperations) {
    record();
    RTT::os::TimeService::Instance()->enableSystemClock(true);
    replay->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0));
    give("Speed", 0.0001);
    ASSERT_TRUE(replay->configure());
    Reader<double> speeds(speedPort());
    ASSERT_TRUE(replay->start());
    const auto waitFor = [&](double last) {
        for (int i = 0; i != 2000; ++i) {
            const auto all = speeds.all();
            if (!all.empty() && all.back() == last) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    };
    EXPECT_TRUE(waitFor(0));
    EXPECT_TRUE(replay->seek(0.07));
    EXPECT_TRUE(waitFor(7));
    EXPECT_TRUE(replay->pause() && replay->step());
    EXPECT_TRUE(waitFor(8));
    give("Speed", 0.0);
    EXPECT_TRUE(replay->resume());
    EXPECT_TRUE(waitFor(9));
}

}  // namespace
