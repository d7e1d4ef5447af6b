// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A replay that is started, stopped, moved and configured anew, while threads read its ports.
#include "replay_fixture.hpp"

#include <ocl/McapReplay.hpp>
#include <rtt/Activity.hpp>

#include <atomic>
#include <chrono>
#include <thread>

namespace {

using namespace replay_test;

class ReplayThreads : public Replay {
protected:
    void SetUp() override {
        Replay::SetUp();
        set("ChunkSize", 4096U);
        ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->reportPort("Machine", "levels"));
        ASSERT_TRUE(recorder->start());
        for (int i = 0; i != 500; ++i) {
            machine.speed.write(i);
            machine.levels.write(std::vector<double>(static_cast<std::size_t>(i % 50), i));
            step(0.0002);
        }
        recorder->stop();
        RTT::os::TimeService::Instance()->enableSystemClock(true);
        replay.reset(new OCL::McapReplay("replay"));
        dynamic_cast<RTT::Property<std::string>&>(*replay->getProperty("ReplayFile")).set(file("run.mcap"));
        dynamic_cast<RTT::Property<bool>&>(*replay->getProperty("Loop")).set(true);
    }
    void TearDown() override {
        replay.reset();
        Replay::TearDown();
    }
    void connect(RTT::InputPort<double>& speeds, RTT::InputPort<std::vector<double>>& levels) {
        ASSERT_TRUE(replay->provides("Machine")->getPort("speed")->connectTo(&speeds, RTT::ConnPolicy::buffer(100)));
        ASSERT_TRUE(replay->provides("Machine")->getPort("levels")->connectTo(&levels));
    }
    /** Does things to the component, while others read its ports and call its operations. */
    template <class Do>
    void whileOthersRead(Do act) {
        RTT::InputPort<double> speeds("speeds");
        RTT::InputPort<std::vector<double>> levels("levels");
        std::atomic<bool> ends{false};
        std::atomic<int> samples{0};
        std::thread reader([&] {
            double speed = 0;
            std::vector<double> level;
            while (!ends) {
                while (speeds.read(speed) == RTT::NewData) ++samples;
                if (levels.read(level) != RTT::NewData) level.clear();
                for (const double one : level) EXPECT_EQ(level.size(), static_cast<std::size_t>(one) % 50);
                std::this_thread::sleep_for(std::chrono::microseconds(50));
            }
        });
        std::thread caller([&] {
            for (unsigned i = 0; !ends; ++i) {
                (void)replay->seek(0.001 * (i % 90));
                (void)replay->pause();
                (void)replay->step();
                (void)replay->resume();
                std::this_thread::sleep_for(std::chrono::microseconds(300));
            }
        });
        act(speeds, levels);
        ends = true;
        reader.join();
        caller.join();
        EXPECT_GT(samples.load(), 10);
    }

    std::unique_ptr<OCL::McapReplay> replay;
};

TEST_F(ReplayThreads, StartAndStop) {
    for (const double period : {0.0, 0.0005}) {
        replay->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, period));
        ASSERT_TRUE(replay->configure());
        whileOthersRead([this](auto& speeds, auto& levels) {
            connect(speeds, levels);
            for (int run = 0; run != 40; ++run) {
                EXPECT_TRUE(replay->start());
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                EXPECT_TRUE(replay->stop());
            }
        });
        ASSERT_TRUE(replay->cleanup());
    }
}

TEST_F(ReplayThreads, ConfigureAnew) {
    replay->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0));
    whileOthersRead([this](auto& speeds, auto& levels) {
        for (int run = 0; run != 40; ++run) {
            EXPECT_TRUE(replay->configure());
            connect(speeds, levels);
            EXPECT_TRUE(replay->start());
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            EXPECT_TRUE(replay->stop() && replay->cleanup());
        }
    });
}

TEST_F(ReplayThreads, AsFastAsPossible) {
    replay->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0));
    dynamic_cast<RTT::Property<double>&>(*replay->getProperty("Speed")).set(0);
    dynamic_cast<RTT::Property<bool>&>(*replay->getProperty("Loop")).set(false);
    ASSERT_TRUE(replay->configure());
    whileOthersRead([this](auto& speeds, auto& levels) {
        connect(speeds, levels);
        for (int run = 0; run != 20; ++run) {
            EXPECT_TRUE(replay->start());
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            // At the end of the recording the component stops itself, and stop() is false while it does.
            while (!replay->stop() && replay->isRunning()) std::this_thread::yield();
        }
    });
}

}  // namespace
