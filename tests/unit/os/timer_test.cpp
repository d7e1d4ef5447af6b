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

TEST(Timer, SaysWhatIsNotATimer) {
    const oroforge::test::LogCapture log;
    TestTimer t(3);
    t.arm(3, 1.0);
    EXPECT_EQ(log.count(3, "invalid timer id 3, there are 3 timers"), 1);
    t.arm(0, -1.0);
    EXPECT_EQ(log.count(3, "invalid wait time for timer 0"), 1);
    t.startTimer(1, -1.0);
    EXPECT_EQ(log.count(3, "invalid period for timer 1"), 1);
    EXPECT_FALSE(t.isArmed(-1));
    EXPECT_EQ(log.count(3, ""), 3);
}

TEST(Timer, MayBeKilledAndArmedAgainFromTimeout) {
    struct Restless : os::Timer {
        std::atomic<int> count{0};
        Restless() : os::Timer(1, ORO_SCHED_OTHER) {}
        ~Restless() override { stopThread(); }
        void timeout(TimerId id) override {
            killTimer(id);
            if (++count < 3) startTimer(id, 0.001);
        }
    } t;
    ASSERT_TRUE(t.startTimer(0, 0.001));
    EXPECT_TRUE(eventually([&] { return t.count == 3; }));
    EXPECT_TRUE(eventually([&] { return !t.isArmed(0); }));
    usleep(5000);
    EXPECT_EQ(t.count, 3);
}

TEST(Timer, FewerTimersKillTheOthersAndFreeTheirWaiters) {
    TestTimer t(3, ORO_SCHED_OTHER);
    ASSERT_TRUE(t.arm(2, 1000.0));
    std::atomic<bool> waiting{false}, returned{false};
    std::thread waiter([&] {
        waiting = true;
        (void)t.waitFor(2);
        returned = true;
    });
    ASSERT_TRUE(eventually([&] { return waiting.load(); }));
    usleep(2000);
    t.setMaxTimers(1);
    EXPECT_TRUE(eventually([&] { return returned.load(); }));
    waiter.join();
    t.setMaxTimers(3);
    EXPECT_FALSE(t.isArmed(2));
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

TEST(Timer, WithAThreadHasAnActivity) {
    TestTimer t(1, ORO_SCHED_OTHER, 0, "Alarm");
    base::ActivityInterface* const a = t.getActivity();
    ASSERT_NE(a, nullptr);
    EXPECT_EQ(a->getRunner(), &t);
    EXPECT_EQ(t.getThread(), a->thread());
    EXPECT_STREQ(a->thread()->getName(), "Alarm");
    EXPECT_TRUE(a->isActive());
    EXPECT_FALSE(a->isPeriodic());
    EXPECT_FALSE(a->isSelf());
    EXPECT_TRUE(a->stop());
    ASSERT_TRUE(t.arm(0, 0.0));
    usleep(2000);
    EXPECT_EQ(t.expired[0], 0);
    EXPECT_TRUE(a->start());
    EXPECT_TRUE(eventually([&] { return t.expired[0] == 1; }));
}

TEST(Timer, WithoutAThreadHasTheActivityThatRunsIt) {
    TestTimer t(1);
    EXPECT_EQ(t.getActivity(), nullptr);
    EXPECT_EQ(t.getThread(), nullptr);
    {
        Activity a(&t);
        EXPECT_EQ(t.getActivity(), &a);
    }
    EXPECT_EQ(t.getActivity(), nullptr);
}

TEST(Timer, MayBeTakenOverByAnActivityOfYours) {
    TestTimer t(1, ORO_SCHED_OTHER);
    Activity a(&t);
    ASSERT_TRUE(a.start());
    EXPECT_EQ(t.getActivity(), &a);
    ASSERT_TRUE(t.arm(0, 0.0));
    EXPECT_TRUE(eventually([&] { return t.expired[0] == 1; }));
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

TEST(Timer, GoesOnAfterAStopThatFailed) {
    struct Slow : TestTimer {
        std::atomic<bool> inside{false}, leave{false};
        using TestTimer::TestTimer;
        void timeout(TimerId id) override {
            TestTimer::timeout(id);
            inside = true;
            eventually([&] { return leave.load(); });
        }
    } t(3);
    Activity a(&t);
    a.setStopTimeout(0.01);
    ASSERT_TRUE(t.arm(0, 0.0));
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return t.inside.load(); }));
    EXPECT_FALSE(a.stop());
    t.leave = true;
    ASSERT_TRUE(t.arm(1, 0.001));
    EXPECT_TRUE(eventually([&] { return t.expired[1] == 1; }));
    a.setStopTimeout(20.0);
    EXPECT_TRUE(a.stop());
}
