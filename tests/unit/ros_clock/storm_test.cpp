// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Threads that start, stop, create and destroy while the time moves.
#include "clock_test.hpp"

#include <rtt_rosclock/rtt_rosclock_sim_clock_thread.h>

#include <memory>
#include <thread>

namespace {

using namespace oroforge::test;
using rtt_rosclock::SimClockActivity;

using Storm = ManualClock;

TEST_F(Storm, AnActivityStopsItselfAndDestroysAnother) {
    Recorder first, second, third, fourth;
    auto a = std::make_unique<SimClockActivity>(0.01, &first);
    auto b = std::make_unique<SimClockActivity>(0.01, &second);
    SimClockActivity c(0.01, &third);
    std::unique_ptr<SimClockActivity> made;
    first.onStep = [&] {
        b.reset();
        made = std::make_unique<SimClockActivity>(0.01, &fourth);
        EXPECT_TRUE(made->start());
        EXPECT_TRUE(a->isSelf());
        EXPECT_TRUE(a->stop());
    };
    ASSERT_TRUE(a->start() && b->start() && c.start());
    ASSERT_TRUE(update(10 * kMs) && update(20 * kMs));
    EXPECT_EQ(first.at.size(), 1u);
    EXPECT_TRUE(second.at.empty());
    EXPECT_EQ(third.at.size(), 2u);
    EXPECT_EQ(fourth.at.size(), 1u);
    EXPECT_FALSE(a->isActive());
    EXPECT_TRUE(a->start());
}

TEST_F(Storm, ActivitiesComeAndGoWhileTheTimeMoves) {
    std::atomic<bool> leave{false};
    std::atomic<int> steps{0};
    std::vector<std::thread> threads;
    threads.emplace_back([&] {
        for (nsecs now = 1; !leave; ++now) update(now % 1000 == 0 ? 0 : now * 5 * kMs);
    });
    for (int t = 0; t != 3; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i != 300; ++i) {
                Recorder r;
                SimClockActivity a(0.005, &r);
                r.onStep = [&] { ++steps; };
                EXPECT_TRUE(a.start());
                a.trigger();
                if (i % 3 == 0) {
                    EXPECT_TRUE(a.stop());
                    EXPECT_TRUE(a.start());
                }
                if (i % 10 == 0) usleep(300);
                a.setPeriod(0.01);
                if (i % 2 == 0) {
                    EXPECT_TRUE(a.stop());
                }
            }
        });
    for (std::size_t t = 1; t != threads.size(); ++t) threads[t].join();
    leave = true;
    threads[0].join();
    EXPECT_GT(steps, 0);
}

TEST_F(Storm, TheSimulationIsSwitchedWhileTheTimeMoves) {
    std::atomic<bool> leave{false};
    Recorder r;
    std::vector<nsecs> inSimulation;
    r.onStep = [&] {
        // An execution may go on when the simulation has ended, in the time of the system.
        const nsecs at = simulated();
        if (rtt_rosclock::SimClockThread::simTimeEnabled() && at == simulated()) inSimulation.push_back(at);
    };
    SimClockActivity a(0.005, &r);
    ASSERT_TRUE(a.start());
    std::thread source([&] {
        for (nsecs now = 1; !leave; ++now) update(now * 5 * kMs);
    });
    for (int i = 0; i != 300; ++i) {
        EXPECT_TRUE(rtt_rosclock::disable_sim());
        EXPECT_TRUE(RTT::os::TimeService::Instance()->systemClockEnabled());
        EXPECT_TRUE(rtt_rosclock::enable_sim());
        if (i % 10 == 0) usleep(300);
    }
    leave = true;
    source.join();
    EXPECT_TRUE(a.stop());
    for (const nsecs at : inSimulation) ASSERT_EQ(at % (5 * kMs), 0);
}

}  // namespace
