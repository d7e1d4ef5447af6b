// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Activities that throw, periods that change, and a thread of the simulation that is stopped.
#include "clock_test.hpp"

#include <rtt_rosclock/rtt_rosclock_sim_clock_thread.h>

#include <stdexcept>
#include <thread>

namespace {

using namespace oroforge::test;
using rtt_rosclock::SimClockActivity;
using rtt_rosclock::SimClockThread;

using Faults = ManualClock;

TEST_F(Faults, AShorterPeriodDoesNotMoveTheTimeBack) {
    Recorder r;
    SimClockActivity a(1.0, &r);
    ASSERT_TRUE(a.start() && update(20 * kMs));
    ASSERT_TRUE(a.setPeriod(0.001));
    ASSERT_TRUE(update(23 * kMs));
    EXPECT_EQ(r.at, (std::vector<nsecs>{21 * kMs, 22 * kMs, 23 * kMs}));
}

TEST_F(Faults, TheTimeNeverMovesBackWhileActivitiesStart) {
    std::atomic<bool> leave{false};
    std::atomic<nsecs> latest{0};
    Recorder every;
    int back = 0, off = 0;
    every.onStep = [&] {
        if (simulated() < latest.exchange(simulated())) ++back;
    };
    SimClockActivity clock(0.001, &every);
    ASSERT_TRUE(clock.start());
    std::thread starter([&] {
        Recorder r;
        SimClockActivity a(0.002, &r);
        while (!leave) {
            EXPECT_TRUE(a.start());
            EXPECT_TRUE(a.stop());
        }
        for (const nsecs at : r.at)
            if (at % (2 * kMs) != 0) ++off;
    });
    for (nsecs now = 7 * kMs; now < 14000 * kMs; now += 7 * kMs) EXPECT_TRUE(update(now));
    leave = true;
    starter.join();
    EXPECT_EQ(back, 0);
    EXPECT_EQ(off, 0);
}

TEST_F(Faults, AnActivityThatStopsTheThreadReleasesTheOneThatWaits) {
    const auto thread = SimClockThread::Instance();
    Recorder r;
    SimClockActivity a(0.01, &r);
    r.onStep = [&] { EXPECT_TRUE(thread->stop()); };
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(update(30 * kMs));
    EXPECT_EQ(r.at, (std::vector<nsecs>{10 * kMs}));
    EXPECT_FALSE(update(40 * kMs));  // nothing would execute it
    ASSERT_TRUE(eventually([&] { return !thread->isActive(); }));
    r.onStep = nullptr;
    ASSERT_TRUE(thread->start());
    EXPECT_TRUE(update(50 * kMs));
    EXPECT_EQ(r.at.back(), 50 * kMs);
}

TEST_F(Faults, AStopOfTheThreadReleasesAllThatWait) {
    const auto thread = SimClockThread::Instance();
    std::atomic<bool> entered{false}, leave{false};
    std::atomic<int> refused{0};
    Recorder r;
    SimClockActivity a(0.01, &r);
    r.onStep = [&] {
        entered = true;
        eventually([&] { return leave.load(); });
    };
    ASSERT_TRUE(a.start());
    std::vector<std::thread> sources;
    for (int i = 0; i != 3; ++i)
        sources.emplace_back([&] {
            if (!update(100 * kMs)) ++refused;
        });
    ASSERT_TRUE(eventually([&] { return entered.load(); }));
    usleep(20000);
    thread->setStopTimeout(20);
    std::thread stopper([&] { EXPECT_TRUE(thread->stop()); });
    EXPECT_TRUE(eventually([&] { return !thread->isRunning(); }));
    leave = true;
    stopper.join();
    for (std::thread& source : sources) source.join();
    EXPECT_EQ(refused, 3);
    EXPECT_EQ(r.at.size(), 1u);
    r.onStep = nullptr;
    ASSERT_TRUE(thread->start());
    EXPECT_TRUE(update(200 * kMs));
}

TEST_F(Faults, AnExceptionInATriggerStopsTheActivityAlone) {
    struct Throws : Recorder {
        void work(WorkReason reason) override {
            if (reason == Trigger) throw std::runtime_error("as the test wants");
        }
    } first;
    Recorder second;
    SimClockActivity a(0.01, &first), b(0.01, &second);
    ASSERT_TRUE(a.start() && b.start() && a.trigger());
    EXPECT_TRUE(eventually([&] { return !a.isActive(); }));
    second.onStep = [&] { a.trigger(); };
    ASSERT_TRUE(a.start() && update(10 * kMs) && update(20 * kMs));
    EXPECT_FALSE(a.isActive());
    EXPECT_EQ(first.at.size(), 1u);
    EXPECT_EQ(second.at.size(), 2u);
}

}  // namespace
