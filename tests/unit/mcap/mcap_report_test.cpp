// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What McapReporting records, and what it says of that which it loses.
#include "mcap_report_fixture.hpp"

#include <fcntl.h>
#include <numeric>
#include <sys/stat.h>
#include <thread>

namespace {

using namespace mcap_test;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

TEST_F(Recorder, HasEverySampleBetweenTwoCycles) {
    ASSERT_TRUE(recorder->reportComponent("Machine"));
    ASSERT_TRUE(recorder->reportPort("Machine", "motor.current"));
    machine.speed.write(-1);  // before the recording
    ASSERT_TRUE(recorder->start());
    for (int i = 0; i != 100; ++i) {
        machine.speed.write(i);
        machine.place.write({1.0 * i, 2});
        if (i % 10 == 9) step();
    }
    machine.current.write(2.5F);  // read by stop()
    recorder->stop();
    const Found found = read();
    EXPECT_THAT(found.problems, IsEmpty());
    EXPECT_TRUE(found.scanned.hasEnd);
    EXPECT_THAT(found.headers, ElementsAre("ros2"));
    std::vector<double> all(100);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(all, numbersOf(found, "/Machine/speed"));
    EXPECT_THAT(found.messages, SizeIs(201));
    const Channel& current = found.channels.back();
    EXPECT_EQ("/Machine/motor/current", current.topic);
    EXPECT_EQ("cdr", current.encoding);
    EXPECT_EQ("Machine.motor.current", current.metadata.at("oroforge.source"));
    EXPECT_EQ("std_msgs/msg/Float32", found.schemas.at(current.schema - 1U).name);
    EXPECT_EQ("component", found.allMetadata[0].texts.at("clock"));
    EXPECT_EQ("0", found.allMetadata.back().texts.at("all"));
    std::uint64_t before = 0;
    for (const Told& one : found.messages)
        if (std::get<0>(one) == 1) {
            EXPECT_GE(std::get<2>(one), before);
            before = std::get<2>(one);
        }
}

TEST_F(Recorder, IsWokenByDataWithoutAPeriod) {
    recorder->setActivity(new RTT::extras::SequentialActivity());
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    for (int i = 0; i != 5; ++i) machine.speed.write(i);
    recorder->stop();
    EXPECT_EQ((std::vector<double>{0, 1, 2, 3, 4}), numbersOf(read(), "/Machine/speed"));
}

TEST_F(Recorder, CountsWhatABufferDropped) {
    const LogText log;
    RTT::ConnPolicy policy = RTT::ConnPolicy::circularBuffer(10);
    set("ReportPolicy", policy);
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    machine.speed.write(0);
    step();
    for (int i = 1; i != 51; ++i) machine.speed.write(i);
    step();
    recorder->stop();
    const Found found = read();
    ASSERT_THAT(found.messages, SizeIs(11));
    EXPECT_EQ(0U, std::get<1>(found.messages[0]));
    EXPECT_EQ(41U, std::get<1>(found.messages[1]));
    EXPECT_EQ(50U, std::get<1>(found.messages[10]));
    EXPECT_EQ("40", found.allMetadata.back().texts.at("all"));
    EXPECT_EQ("40", found.allMetadata.back().texts.at("/Machine/speed"));
    EXPECT_THAT(log(), HasSubstr("40 messages of the recording of 'Recorder' are lost"));
}

TEST_F(Recorder, HasPropertiesWhenTheyChange) {
    ASSERT_TRUE(recorder->reportData("Machine", "gain") && recorder->start());
    for (int i = 0; i != 6; ++i) {
        if (i == 3) machine.gain = 2.5;
        step();
    }
    recorder->stop();
    EXPECT_EQ((std::vector<double>{1.5, 2.5}), numbersOf(read(), "/Machine/gain"));
    EXPECT_EQ("value", read().channels.at(0).metadata.at("oroforge.kind"));
}

TEST_F(Recorder, TakesMessagesLargerThanAChunk) {
    set("ChunkSize", 4096U);
    ASSERT_TRUE(recorder->reportPort("Machine", "levels") && recorder->start());
    for (const std::size_t size : {10U, 5000U, 3U, 100000U, 5000U}) machine.levels.write(std::vector<double>(size, 1));
    step();
    recorder->stop();
    const Found found = read();
    ASSERT_THAT(found.messages, SizeIs(5));
    EXPECT_EQ(4 + 4 + 4 + 100000 * 8U, std::get<3>(found.messages[3]).size());
}

TEST_F(Recorder, HasTheStatesOfPeers) {
    set("States", true);
    ASSERT_TRUE(recorder->reportPort("Machine", "speed"));
    for (const bool isReproducible : {false, true}) {
        set("Reproducible", isReproducible);
        auto other = std::make_unique<RTT::TaskContext>("Other", RTT::TaskContext::PreOperational);
        recorder->addPeer(other.get());
        ASSERT_TRUE(recorder->start());
        step();
        other->configure();
        step();
        machine.speed.write(1);
        other->start();
        step();
        step();
        other.reset();
        step();
        recorder->stop();
        const Found found = read();
        ASSERT_THAT(found.channels, SizeIs(2));
        EXPECT_EQ("/oroforge/states", found.channels[1].topic);
        EXPECT_EQ("oroforge/msg/ComponentState", found.schemas.at(found.channels[1].schema - 1U).name);
        std::vector<std::string> states;
        for (const auto& [channel, sequence, time, data] : found.messages) {
            if (channel != 2) continue;
            EXPECT_EQ(states.size(), sequence);
            // Behind the head there are texts with their sizes, at multiples of four.
            const std::string component = data.c_str() + 8;
            states.push_back(component + " " + (data.c_str() + 8 + (component.size() + 4) / 4 * 4 + 4));
        }
        EXPECT_THAT(states, ElementsAre("Machine Stopped", "Other PreOperational", "Other Stopped", "Other Running",
                                        "Other Destroyed"));
    }
}

TEST_F(Recorder, DoesNotStartIfTheFileCannotBeWritten) {
    const LogText log;
    set<std::string>("ReportFile", file("no/such/run.mcap"));
    ASSERT_TRUE(recorder->reportPort("Machine", "speed"));
    EXPECT_FALSE(recorder->start());
    EXPECT_THAT(log(), HasSubstr("/no/such/run.mcap' for recording: No such file or directory"));
    set<std::string>("ReportFile", "/dev/full");
    EXPECT_FALSE(recorder->start());
    EXPECT_THAT(log(), HasSubstr("/dev/full: byte 0: error: [MCP009] the recording cannot be written: No space left"));
}

TEST_F(Recorder, ReportsOnceThatNothingMoreCanBeWritten) {
    const LogText log;
    const std::string pipe = file("pipe");
    ASSERT_EQ(0, mkfifo(pipe.c_str(), 0600));
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    set<std::string>("ReportFile", pipe);
    set("ChunkSize", 4096U);
    set("ChunkTime", 0.01);
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    close(reader);
    for (int i = 0; i != 2000 && !recorder->inRunTimeError(); ++i) {
        machine.speed.write(i);
        step();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_TRUE(recorder->inRunTimeError());
    recorder->stop();
    const std::string said = log();
    const std::size_t first = said.find("[MCP009] the recording cannot be written: Broken pipe");
    ASSERT_NE(said.npos, first) << said;
    EXPECT_EQ(said.npos, said.find("MCP009", first + 10));
    EXPECT_THAT(said, HasSubstr("messages of the recording of 'Recorder' are lost"));
}

TEST_F(Recorder, RefusesPropertiesThatMakeNoSense) {
    const LogText log;
    ASSERT_TRUE(recorder->reportPort("Machine", "speed"));
    const auto refuses = [&](const std::string& property, auto wrong, auto right, const std::string& said) {
        set(property, wrong);
        EXPECT_FALSE(recorder->start()) << property;
        EXPECT_THAT(log(), HasSubstr(said));
        set(property, right);
    };
    const std::string none;
    refuses("Compression", std::string("zst"), std::string("none"), "found 'zst', expected one of none, ");
    refuses("Clock", std::string("wall"), std::string("component"), "property Clock: found 'wall'");
    refuses("Schema", std::string("idl"), std::string("auto"), "property Schema: found 'idl'");
    for (const char* const split : {"5", "x MB", "-1 s", "1e300 GB", "nan s", "5 MBit"})
        refuses("Split", std::string(split), none, "property Split: found '" + std::string(split) + "'");
    refuses("ChunkSize", 0U, 4096U, "property ChunkSize: found 0, expected 4096 to");
    refuses("ChunkSize", ~0U, 4096U, "property ChunkSize: found 4294967295");
    refuses("ChunkTime", 0.0, 0.5, "property ChunkTime: found 0.0");
    for (const char* const size : {"", "5", "0 MB", "5 s"})
        refuses("RingSize", std::string(size), std::string("1 GB"), "property RingSize: found '" + std::string(size));
    refuses("Ring", -1.0, 0.0, "property Ring: found -1.0");
    EXPECT_TRUE(recorder->start());
}

TEST_F(Recorder, LeavesOutWhatHasNoDescriptionAndSaysSo) {
    const LogText log;
    set<std::string>("Schema", "ros2msg");
    ASSERT_TRUE(recorder->reportData("Machine", "limits"));
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    EXPECT_THAT(log(), HasSubstr("'Recorder' does not record 'Machine.limits': error: [MCP011] "));
    machine.speed.write(1);
    step();
    recorder->stop();
    EXPECT_THAT(read().messages, SizeIs(1));
}

TEST_F(Recorder, HasTheTimeOfDayIfAsked) {
    set<std::string>("Clock", "realtime");
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    machine.speed.write(1);
    step();
    recorder->stop();
    const Found found = read();
    ASSERT_THAT(found.messages, SizeIs(1));
    const auto age =
        static_cast<double>(std::time(nullptr)) - static_cast<double>(std::get<2>(found.messages[0])) / 1e9;
    EXPECT_LT(std::abs(age), 30);
    EXPECT_THAT(found.allMetadata[0].texts.at("host"), Not(IsEmpty()));
    EXPECT_THAT(found.allMetadata[0].texts.at("command"), HasSubstr("mcap_report_test"));
    EXPECT_EQ(std::filesystem::current_path(), found.allMetadata[0].texts.at("folder"));
}

TEST_F(Recorder, ReproducibleIsTheSameFileEachTime) {
    const LogText log;
    set("Reproducible", true);
    set<std::string>("Clock", "realtime");
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->reportData("Machine", "limits"));
    EXPECT_FALSE(recorder->start());
    EXPECT_THAT(log(), HasSubstr("the property Reproducible needs Clock=component"));
    set<std::string>("Clock", "component");
    set("ChunkSize", 4096U);
    set("ChunkTime", 0.1);
    set("States", true);
    std::vector<std::string> files;
    RTT::os::TimeService& time = *RTT::os::TimeService::Instance();
    const RTT::nsecs begin = time.getNSecs() + 1000000000;
    for (int run = 0; run != 2; ++run) {
        while (time.getNSecs() != begin) {
            const auto off = static_cast<double>(begin - time.getNSecs());
            time.secondsChange((off > 0 ? off + 0.4 : off - 0.4) / 1e9);
        }
        ASSERT_TRUE(recorder->start());
        for (int i = 0; i != 3000; ++i) {
            machine.speed.write(i);
            // The second time messages are older than ChunkTime by the time of day.
            if (run == 1 && i % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(120));
            if (i < 1500) machine.speed.write(i);
            step(i < 1500 ? 0.0 : 0.01);
        }
        recorder->stop();
        EXPECT_EQ(4500U, numbersOf(read(), "/Machine/speed").size());
        EXPECT_THAT(read().allMetadata.at(0).texts, SizeIs(6));
        files.push_back(oroforge::test::readFile(directory / "run.mcap"));
    }
    EXPECT_TRUE(files[0] == files[1]);
}

TEST_F(Recorder, WithoutAPeriodTakesSamplesInTheOrderOfItsPorts) {
    recorder->setActivity(new RTT::extras::SlaveActivity(0.0));
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->reportPort("Machine", "levels"));
    for (int run = 0; run != 2; ++run) {
        machine.levels.write({-1});  // before the start: forgotten
        ASSERT_TRUE(recorder->start());
        step();
        for (int i = 0; i != 5; ++i) {
            machine.levels.write({1.0 * i});
            if (i % 2 == 0) machine.speed.write(i);
            machine.levels.write({10.0 + i});
            step();
        }
        machine.levels.write({99});
        recorder->stop();
        std::vector<unsigned> channels;
        const Found found = read();
        for (const auto& message : found.messages) channels.push_back(std::get<0>(message));
        EXPECT_THAT(channels, ElementsAre(1, 2, 2, 2, 2, 1, 2, 2, 2, 2, 1, 2, 2, 2));
        EXPECT_EQ((std::vector<double>{0, 2, 4}), numbersOf(found, "/Machine/speed"));
    }
}

TEST_F(Recorder, RunsAgainAndTheFileBeginsAnew) {
    ASSERT_TRUE(recorder->reportPort("Machine", "speed"));
    for (int run = 0; run != 3; ++run) {
        ASSERT_TRUE(recorder->start());
        machine.speed.write(run);
        recorder->stop();
        EXPECT_EQ(std::vector<double>{1.0 * run}, numbersOf(read(), "/Machine/speed"));
    }
}

}  // namespace
