// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/Activity.hpp>
#include <rtt/os/Timer.hpp>

#include <thread>

using namespace RTT;
using oroforge::test::eventually;

namespace {

struct TestTimer : os::Timer {
    std::atomic<int> expired[3] = {};
    using os::Timer::Timer;
    ~TestTimer() override { stopThread(); }
    void timeout(TimerId id) override { ++expired[id]; }
};

}  // namespace

TEST(Timer, PeriodicTimerExpiresAgainAndAgain) {
    TestTimer t(3, ORO_SCHED_OTHER);
    const nsecs start = rtos_get_time_ns();
    ASSERT_TRUE(t.startTimer(1, 0.005));
    EXPECT_TRUE(t.isArmed(1));
    EXPECT_TRUE(eventually([&] { return t.expired[1] >= 3; }));
    EXPECT_GE(rtos_get_time_ns() - start, 15000000);
    EXPECT_TRUE(t.killTimer(1));
    EXPECT_FALSE(t.isArmed(1));
    const int count = t.expired[1];
    usleep(15000);
    EXPECT_LE(t.expired[1], count + 1);  // one may have been on its way
    EXPECT_EQ(t.expired[0], 0);
}

TEST(Timer, OneShotExpiresOnce) {
    TestTimer t(3, ORO_SCHED_OTHER);
    ASSERT_TRUE(t.arm(0, 0.002));
    EXPECT_TRUE(eventually([&] { return t.expired[0] == 1; }));
    EXPECT_FALSE(t.isArmed(0));
    EXPECT_EQ(t.timeRemaining(0), 0.0);
    usleep(5000);
    EXPECT_EQ(t.expired[0], 1);
}

TEST(Timer, TellsTheTimeThatRemains) {
    TestTimer t(3, ORO_SCHED_OTHER);
    ASSERT_TRUE(t.arm(2, 100.0));
    EXPECT_GT(t.timeRemaining(2), 50.0);
    EXPECT_LE(t.timeRemaining(2), 100.0);
}

TEST(Timer, StopsAtOnceWhereverItsThreadIs) {
    // The thread may be just about to enter its wait.
    for (int i = 0; i < 500; ++i) {
        TestTimer t(1, ORO_SCHED_OTHER);
        ASSERT_TRUE(t.arm(0, 100.0));
    }
}

TEST(Timer, RefusesWhatIsNotATimer) {
    TestTimer t(3);
    EXPECT_FALSE(t.arm(3, 1.0));
    EXPECT_FALSE(t.arm(-1, 1.0));
    EXPECT_FALSE(t.arm(0, -1.0));
    EXPECT_FALSE(t.startTimer(0, 0.0));
    EXPECT_FALSE(t.startTimer(0, -1.0));
    EXPECT_FALSE(t.killTimer(3));
    EXPECT_FALSE(t.isArmed(3));
    EXPECT_FALSE(t.waitFor(0));
    t.setMaxTimers(1);
    EXPECT_FALSE(t.arm(2, 1.0));
}

TEST(Timer, WaitForReturnsAtExpiryAndWhenKilled) {
    TestTimer t(3, ORO_SCHED_OTHER);
    ASSERT_TRUE(t.arm(0, 0.01));
    EXPECT_TRUE(t.waitFor(0));
    ASSERT_TRUE(t.arm(1, 1000.0));
    EXPECT_FALSE(t.waitForUntil(1, rtos_get_time_ns() + 5000000));
    std::thread killer([&] {
        usleep(5000);
        t.killTimer(1);
    });
    EXPECT_TRUE(t.waitFor(1));
    killer.join();
}

TEST(Timer, RunsInAnActivityOfYours) {
    TestTimer t(3);
    Activity a(&t);
    ASSERT_TRUE(t.arm(0, 0.002));
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return t.expired[0] == 1; }));
    EXPECT_TRUE(a.stop());
    ASSERT_TRUE(t.arm(0, 0.002));
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return t.expired[0] == 2; }));
    EXPECT_TRUE(a.stop());
}

TEST(Timer, MayBeSetFromTimeout) {
    struct Chain : TestTimer {
        using TestTimer::TestTimer;
        ~Chain() override { stopThread(); }
        void timeout(TimerId id) override {
            TestTimer::timeout(id);
            if (id < 2) arm(id + 1, 0.001);
        }
    } t(3, ORO_SCHED_OTHER);
    t.arm(0, 0.0);
    EXPECT_TRUE(eventually([&] { return t.expired[2] == 1; }));
}
