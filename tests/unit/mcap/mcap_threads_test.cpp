// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Threads that write, a recorder that is started, stopped and saved meanwhile: every message is there, or counted.
#include "mcap_report_fixture.hpp"

#include <atomic>
#include <thread>

namespace {

using namespace mcap_test;

class RecorderThreads : public Recorder {
protected:
    void SetUp() override {
        Recorder::SetUp();
        RTT::os::TimeService::Instance()->enableSystemClock(true);
        recorder->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001));
        set("ChunkSize", 4096U);
        set("ChunkTime", 0.002);
    }
};

TEST_F(RecorderThreads, EveryMessageIsThereOrCounted) {
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->reportPort("Machine", "levels"));
    ASSERT_TRUE(recorder->start());
    std::thread other([this] {
        for (int i = 0; i != 3000; ++i) machine.levels.write(std::vector<double>(static_cast<std::size_t>(i % 200), i));
    });
    for (int i = 0; i != 20000; ++i) machine.speed.write(i);
    other.join();
    recorder->stop();
    const Found found = read();
    EXPECT_TRUE(found.scanned.hasEnd && found.problems.empty());
    ASSERT_EQ(2U, found.allMetadata.size());
    EXPECT_EQ(23000U, found.messages.size() + std::stoul(found.allMetadata.back().texts.at("all")));
    std::uint32_t next[3] = {};
    for (const auto& [channel, sequence, time, data] : found.messages) {
        ASSERT_GE(sequence, next[channel]);
        next[channel] = sequence + 1;
        if (channel != 1) continue;
        double number = 0;
        std::memcpy(&number, data.data() + 4, sizeof number);
        // The gaps are where samples are missing, or in front of the sample before, if one is dropped just then; or
        // later by one sample, while the thread that dropped it has not counted it yet.
        EXPECT_GE(sequence + 1, number);
    }
}

TEST_F(RecorderThreads, HasTheStatesOfComponentsThatAreDestroyedMeanwhile) {
    set("States", true);
    ASSERT_TRUE(recorder->reportPort("Machine", "speed"));
    for (int run = 0; run != 20; ++run) {
        auto other = std::make_unique<RTT::TaskContext>("Other");
        recorder->addPeer(other.get());
        ASSERT_TRUE(recorder->start());
        for (int i = 0; i != 30; ++i) {
            EXPECT_TRUE(other->start() && other->stop());
            machine.speed.write(i);
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
        other.reset();
        recorder->stop();
        const Found found = read();
        EXPECT_TRUE(found.scanned.hasEnd && found.problems.empty());
        std::string last;
        for (const auto& [channel, sequence, time, data] : found.messages)
            if (channel == 2) last = data;
        EXPECT_THAT(last, HasSubstr("Destroyed"));
    }
}

TEST_F(RecorderThreads, SavesAndStopsAtAnyTime) {
    set("Ring", 0.05);
    ASSERT_TRUE(recorder->reportPort("Machine", "levels"));
    std::atomic<bool> end{false};
    std::thread writer([&] {
        while (!end) {
            machine.levels.write(std::vector<double>(100, 1));
            std::this_thread::yield();
        }
    });
    std::thread saver([&] {
        while (!end) {
            (void)recorder->save();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    for (int i = 0; i != 20; ++i) {
        ASSERT_TRUE(recorder->start());
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        recorder->stop();
    }
    end = true;
    writer.join();
    saver.join();
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(directory.path())) {
        const Found found = read(entry.path().filename().string());
        EXPECT_TRUE(found.scanned.hasEnd && found.problems.empty()) << entry.path();
        ++files;
    }
    EXPECT_GT(files, 0U);
}

}  // namespace
