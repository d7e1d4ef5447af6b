// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "activity_stop.hpp"

#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/os/MainThread.hpp>

#include <stdexcept>
#include <thread>
#include <vector>

using namespace RTT;
using extras::SequentialActivity;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;

TEST(SequentialActivity, TriggerExecutesInTheCaller) {
    CountingRunner r;
    SequentialActivity a(&r);
    std::thread::id in;
    bool running = false;
    r.onStep = [&] {
        in = std::this_thread::get_id();
        running = a.isRunning() && a.isSelf();
    };
    EXPECT_FALSE(a.trigger());
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.start());
    EXPECT_FALSE(a.isRunning());
    EXPECT_TRUE(a.trigger());
    EXPECT_EQ(r.steps, 1);
    EXPECT_EQ(r.timeouts, 1);
    EXPECT_EQ(r.triggers, 0);
    EXPECT_EQ(in, std::this_thread::get_id());
    EXPECT_TRUE(running);
    EXPECT_TRUE(a.timeout());
    EXPECT_EQ(r.steps, 2);
    EXPECT_TRUE(a.stop());
    EXPECT_FALSE(a.stop());
    EXPECT_EQ(r.finalized, 1);
}

TEST(SequentialActivity, HasNoThreadAndNoPeriod) {
    SequentialActivity a;
    EXPECT_EQ(a.thread(), os::MainThread::Instance());
    EXPECT_EQ(a.getPeriod(), 0.0);
    EXPECT_FALSE(a.isPeriodic());
    EXPECT_TRUE(a.setPeriod(0.0));
    EXPECT_FALSE(a.setPeriod(0.1));
    EXPECT_EQ(a.getCpuAffinity(), ~0u);
    EXPECT_FALSE(a.setCpuAffinity(1));
    EXPECT_FALSE(a.execute());
    EXPECT_TRUE(a.isSelf());  // in the main thread, because nobody else can execute it
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.isSelf());
}

TEST(SequentialActivity, RecursionReturnsAtOnce) {
    CountingRunner r;
    SequentialActivity a(&r);
    r.onStep = [&] { EXPECT_TRUE(a.trigger()); };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.trigger());
    EXPECT_EQ(r.steps, 1);
}

TEST(SequentialActivity, RepeatsWhileThereIsWork) {
    CountingRunner r;
    SequentialActivity a(&r);
    r.onStep = [&] { r.hasWorkResult = r.steps < 3; };
    ASSERT_TRUE(a.start());
    r.hasWorkResult = true;
    EXPECT_TRUE(a.trigger());
    EXPECT_EQ(r.steps, 3);
}

TEST(SequentialActivity, MayBeStoppedFromWithin) {
    CountingRunner r;
    SequentialActivity a(&r);
    r.onStep = [&] { EXPECT_TRUE(a.stop()); };
    ASSERT_TRUE(a.start());
    r.hasWorkResult = true;
    EXPECT_TRUE(a.trigger());
    EXPECT_FALSE(a.isActive());
    EXPECT_EQ(r.steps, 1);
    EXPECT_EQ(r.finalized, 1);
}

TEST(SequentialActivity, ExceptionReachesTheCallerAndFreesIt) {
    CountingRunner r;
    SequentialActivity a(&r);
    r.onStep = [&] { throw std::runtime_error("boom"); };
    ASSERT_TRUE(a.start());
    EXPECT_THROW(a.trigger(), std::runtime_error);
    r.onStep = nullptr;
    EXPECT_TRUE(a.trigger());
    EXPECT_EQ(r.steps, 2);
}

TEST(SequentialActivity, StopWaitsForAnotherThread) {
    CountingRunner r;
    SequentialActivity a(&r);
    std::atomic<bool> inside{false}, left{false};
    r.onStep = [&] {
        inside = true;
        usleep(20000);
        left = true;
    };
    ASSERT_TRUE(a.start());
    std::thread caller([&] { a.trigger(); });
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_TRUE(eventually([&] { return a.stop(); }));
    EXPECT_TRUE(left);
    caller.join();
}

TEST(SequentialActivity, StartAndStopFromSeveralThreads) {
    CountingRunner r;
    SequentialActivity a(&r);
    std::vector<std::thread> threads;
    for (int t = 0; t < 3; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i < 1000; ++i) a.start(), a.trigger(), a.stop();
        });
    for (std::thread& thread : threads) thread.join();
    (void)a.stop();
    EXPECT_EQ(r.initialized, r.finalized);
}

TEST(SequentialActivity, MessagesThatCameWhileItWasStoppedAreExecuted) {
    CountingRunner r;
    r.onStep = [&] { r.hasWorkResult = false; };
    SequentialActivity a(&r);
    ASSERT_TRUE(a.start());
    EXPECT_EQ(r.steps, 0);
    EXPECT_TRUE(a.stop());
    r.hasWorkResult = true;
    EXPECT_FALSE(a.trigger());
    ASSERT_TRUE(a.start());
    EXPECT_EQ(r.steps, 1);
}

TEST(SequentialActivity, StopWaitsForOneThatStoppedItself) {
    CountingRunner r;
    SequentialActivity a(&r);
    oroforge::test::expectStopWaitsForOneThatStoppedItself(a, r.onStep, [&] { a.trigger(); });
}

TEST(SequentialActivity, IsActiveUntilStopHasWaited) {
    CountingRunner r;
    SequentialActivity a(&r);
    oroforge::test::expectActiveUntilStopHasWaited(
        a, r.onStep, [&] { return !a.trigger(); }, [&] { a.trigger(); });
}
