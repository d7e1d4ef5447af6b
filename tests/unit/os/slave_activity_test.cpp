// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "message_runner.hpp"

#include <rtt/Activity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/MainThread.hpp>

#include <mutex>
#include <thread>

using namespace RTT;
using extras::SlaveActivity;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::MessageRunner;

TEST(SlaveActivity, WithoutMasterExecutesInTheCaller) {
    CountingRunner r;
    SlaveActivity a(&r);
    EXPECT_FALSE(a.execute());
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.start());
    EXPECT_TRUE(a.execute());
    EXPECT_EQ(r.loops, 1);
    EXPECT_EQ(r.timeouts, 1);
    EXPECT_EQ(r.steps, 0);
    EXPECT_FALSE(a.trigger());
    EXPECT_FALSE(a.timeout());
    EXPECT_FALSE(a.isPeriodic());
    EXPECT_EQ(a.thread(), os::MainThread::Instance());
    EXPECT_EQ(a.getCpuAffinity(), ~0u);
    EXPECT_TRUE(a.stop());
    EXPECT_FALSE(a.stop());
    EXPECT_FALSE(a.execute());
}

TEST(SlaveActivity, PeriodicOneSteps) {
    CountingRunner r;
    SlaveActivity a(0.1, &r);
    EXPECT_TRUE(a.isPeriodic());
    EXPECT_EQ(a.getPeriod(), 0.1);
    EXPECT_TRUE(a.setPeriod(0.2));
    EXPECT_FALSE(a.setPeriod(0.0));
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.isRunning());
    EXPECT_TRUE(a.execute());
    EXPECT_EQ(r.steps, 1);
    EXPECT_EQ(r.loops, 0);
    EXPECT_EQ(r.timeouts, 1);
}

TEST(SlaveActivity, DoesNotExecuteInItself) {
    CountingRunner r;
    SlaveActivity a(&r);
    bool again = true;
    r.onLoop = [&] { again = a.execute(); };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.execute());
    EXPECT_FALSE(again);
    EXPECT_EQ(r.loops, 1);
}

TEST(SlaveActivity, FollowsItsMaster) {
    MessageRunner masterRunner;
    Activity master(ORO_SCHED_OTHER, 0, 30.0, &masterRunner);
    CountingRunner r;
    SlaveActivity a(&master, &r);
    EXPECT_FALSE(a.start());  // the master is not active
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(a.start());
    EXPECT_EQ(a.getPeriod(), 30.0);
    EXPECT_TRUE(a.isPeriodic());
    EXPECT_FALSE(a.setPeriod(1.0));
    EXPECT_EQ(a.thread(), master.thread());
    std::atomic<bool> inMaster{false};
    r.onWork = [&](auto) { inMaster = master.isSelf() && a.isSelf(); };
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return r.triggers == 1; }));
    EXPECT_TRUE(eventually([&] { return inMaster.load(); }));
    EXPECT_EQ(r.timeouts, 0);
    EXPECT_TRUE(master.setPeriod(0.0));
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(a.stop());
    EXPECT_FALSE(a.trigger());
    EXPECT_TRUE(eventually([&] { return master.stop(); }));
}

TEST(SlaveActivity, MasterThatTakesNoMessagesRefusesTriggers) {
    CountingRunner masterRunner;
    Activity master(&masterRunner);
    CountingRunner r;
    SlaveActivity a(&master, &r);
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.trigger());
    EXPECT_FALSE(a.trigger());  // the message is free again
}

TEST(SlaveActivity, TriggersAndUpdatesNeverExecuteTogether) {
    MessageRunner masterRunner;
    Activity master(&masterRunner);
    CountingRunner r;
    int inside = 0;  // not atomic: one thread at a time
    r.onWork = [&](auto) { ++inside; };
    SlaveActivity a(&master, &r);
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(a.start());
    std::thread updates([&] {
        for (int i = 0; i < 3000; ++i) a.execute();
    });
    for (int i = 0; i < 3000; ++i) EXPECT_TRUE(a.trigger());
    updates.join();
    EXPECT_TRUE(eventually([&] { return master.stop(); }));
    EXPECT_EQ(inside, r.triggers + r.timeouts);
}

TEST(SlaveActivity, TimeoutByTheMasterExecutesIt) {
    MessageRunner masterRunner;
    Activity master(ORO_SCHED_OTHER, 0, 0.002, &masterRunner);
    CountingRunner r;
    SlaveActivity a(&master, &r);
    std::atomic<int> accepted{0}, nested{0};
    r.onStep = [&] {
        if (a.timeout()) ++nested;
    };
    masterRunner.onStep = [&] {
        if (a.timeout()) ++accepted;
    };
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.timeout());  // by another thread: that of a periodic activity
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 3; }));
    EXPECT_TRUE(eventually([&] { return master.stop(); }));
    EXPECT_EQ(accepted, r.timeouts);
    EXPECT_EQ(r.steps, r.timeouts);
    EXPECT_EQ(nested, 0);
    EXPECT_TRUE(a.stop());
}

TEST(SlaveActivity, MessagesThatCameWhileItWasStoppedAreExecuted) {
    MessageRunner masterRunner;
    Activity master(&masterRunner);
    CountingRunner r;
    SlaveActivity a(&master, &r);
    ASSERT_TRUE(master.start());
    r.hasWorkResult = true;
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.triggers == 1; }));
    EXPECT_TRUE(eventually([&] { return master.stop(); }));
}

TEST(SlaveActivity, WithoutMasterItBelongsToTheThreadThatExecutesIt) {
    CountingRunner r;
    SlaveActivity a(&r);
    EXPECT_TRUE(a.isSelf());  // nobody did: the main thread
    ASSERT_TRUE(a.start());
    std::atomic<bool> executed{false}, end{false};
    std::thread other([&] {
        EXPECT_FALSE(a.isSelf());
        EXPECT_TRUE(a.execute());
        EXPECT_TRUE(a.isSelf());
        executed = true;
        EXPECT_TRUE(eventually([&] { return end.load(); }));
    });
    EXPECT_TRUE(eventually([&] { return executed.load(); }));
    EXPECT_FALSE(a.isSelf());
    end = true;
    other.join();
    EXPECT_TRUE(a.isSelf());  // a thread that has ended executes nothing any more
    EXPECT_TRUE(a.execute());
    EXPECT_TRUE(a.isSelf());
}
