// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "activity_stop.hpp"

#include <rtt/extras/PeriodicActivity.hpp>

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace RTT;
using extras::PeriodicActivity;
using extras::TimerThread;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;

TEST(PeriodicActivity, EqualParametersShareAThread) {
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.005);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.005);
    PeriodicActivity other(ORO_SCHED_OTHER, 0, 0.007);
    EXPECT_EQ(a.thread(), b.thread());
    EXPECT_NE(a.thread(), other.thread());
    EXPECT_STREQ(a.thread()->getName(), "TimerThreadInstance");
    EXPECT_EQ(a.getPeriod(), 0.005);
    EXPECT_FALSE(a.setPeriod(0.1));
    EXPECT_FALSE(a.trigger());
    EXPECT_FALSE(a.timeout());
    EXPECT_FALSE(a.execute());
}

TEST(TimerThread, IsSharedByWhatItIsNowNotByWhatItWas) {
    const auto instance = [](int priority, double period) { return TimerThread::Instance(priority, period); };
    const extras::TimerThreadPtr thread = instance(os::LowestPriority, 0.0123);
    EXPECT_EQ(instance(os::LowestPriority, 0.0123), thread);
    EXPECT_NE(instance(os::LowestPriority + 3, 0.0123), thread);
    if (thread->getScheduler() != ORO_SCHED_OTHER) {  // there are priorities
        ASSERT_TRUE(thread->setPriority(os::LowestPriority + 3));
        EXPECT_EQ(instance(os::LowestPriority + 3, 0.0123), thread);
        EXPECT_NE(instance(os::LowestPriority, 0.0123), thread);
        ASSERT_TRUE(thread->setScheduler(ORO_SCHED_OTHER));
        EXPECT_NE(instance(os::LowestPriority + 3, 0.0123), thread);
        EXPECT_EQ(TimerThread::Instance(ORO_SCHED_OTHER, os::LowestPriority, 0.0123), thread);
    }
}

TEST(TimerThread, IsSharedByThePeriodAndTheProcessorsThatWereSet) {
    const auto instance = [](double period, unsigned cpus) {
        return TimerThread::Instance(ORO_SCHED_OTHER, 0, period, cpus);
    };
    const extras::TimerThreadPtr thread = instance(0.0124, 0);
    ASSERT_TRUE(thread->setPeriod(0.0125));
    EXPECT_EQ(instance(0.0125, 0), thread);
    EXPECT_NE(instance(0.0124, 0), thread);
    const unsigned all = thread->getCpuAffinity(), one = all & ~(all - 1);
    if (all == one) return;  // nothing to choose from
    ASSERT_TRUE(thread->setCpuAffinity(one));
    EXPECT_EQ(PeriodicActivity(ORO_SCHED_OTHER, 0, 0.0125, one).thread(), thread.get());
    EXPECT_NE(instance(0.0125, 0), thread);
}

TEST(TimerThread, OfOrdinarySchedulingHasNoPriority) {
    const extras::TimerThreadPtr thread = TimerThread::Instance(ORO_SCHED_OTHER, 15, 0.0126);
    EXPECT_EQ(TimerThread::Instance(ORO_SCHED_OTHER, 0, 0.0126), thread);
    EXPECT_EQ(thread->getPriority(), 0);
}

TEST(PeriodicActivity, ExecutesInOrderOfStart) {
    std::mutex mutex;
    std::string order;
    CountingRunner first, second;
    const auto note = [&](char c) {
        std::lock_guard<std::mutex> lock(mutex);
        order += c;
    };
    first.onStep = [&] { note('a'); };
    second.onStep = [&] { note('b'); };
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.003, &first);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.003, &second);
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.start());
    ASSERT_TRUE(b.start());
    EXPECT_TRUE(a.isRunning());
    EXPECT_TRUE(eventually([&] { return second.timeouts >= 5; }));
    EXPECT_TRUE(a.stop());
    EXPECT_TRUE(b.stop());
    EXPECT_FALSE(a.isActive());
    EXPECT_NE(order.find("ababab"), std::string::npos) << order;
    EXPECT_EQ(first.steps, first.timeouts);
    const int steps = first.steps;
    usleep(10000);
    EXPECT_EQ(first.steps, steps);
}

TEST(PeriodicActivity, MayStopItselfAndItsNeighbour) {
    CountingRunner first, second;
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.002, &first);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.002, &second);
    first.onStep = [&] {
        a.stop();
        b.stop();
    };
    ASSERT_TRUE(b.start());
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return !a.isActive() && !b.isActive(); }));
    EXPECT_TRUE(eventually([&] { return first.finalized == 1 && second.finalized == 1; }));
    first.onStep = nullptr;
    EXPECT_TRUE(b.start());
    const int steps = second.steps;
    EXPECT_TRUE(eventually([&] { return second.steps > steps; }));
}

TEST(PeriodicActivity, ExceptionStopsOnlyThatOne) {
    CountingRunner bad, good;
    bad.onStep = [] { throw std::runtime_error("boom"); };
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.002, &bad);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.002, &good);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(b.start());
    EXPECT_TRUE(eventually([&] { return !a.isActive() && good.steps > 3; }));
    EXPECT_EQ(bad.finalized, 1);
}

TEST(PeriodicActivity, ThreadTakesALimitedNumber) {
    const extras::TimerThreadPtr thread(new TimerThread(ORO_SCHED_OTHER, 0, "limited", 0.01));
    std::vector<std::unique_ptr<CountingRunner>> runners;
    std::vector<std::unique_ptr<PeriodicActivity>> activities;
    for (std::size_t i = 0; i <= TimerThread::MAX_ACTIVITIES; ++i) {
        runners.emplace_back(new CountingRunner);
        activities.emplace_back(new PeriodicActivity(thread, runners.back().get()));
        EXPECT_EQ(activities.back()->start(), i < TimerThread::MAX_ACTIVITIES);
    }
    EXPECT_FALSE(activities.back()->isActive());
    EXPECT_TRUE(activities.front()->stop());
    EXPECT_TRUE(activities.back()->start());
    activities.clear();
}

TEST(PeriodicActivity, SetsThePeriodOfAThreadOfYours) {
    const extras::TimerThreadPtr thread(new TimerThread(ORO_SCHED_OTHER, 0, "mine", 0.5));
    PeriodicActivity a(0, 4000000, thread);
    EXPECT_EQ(a.getPeriod(), 0.004);
}

TEST(PeriodicActivity, SubClassMayReplaceTheRunner) {
    struct Counter : PeriodicActivity {
        std::atomic<int> steps{0}, initialized{0}, finalized{0};
        Counter() : PeriodicActivity(ORO_SCHED_OTHER, 0, 0.002) {}
        ~Counter() override { stop(); }
        bool initialize() override { return ++initialized > 0; }
        void step() override { ++steps; }
        void finalize() override { ++finalized; }
    } a;
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return a.steps >= 3; }));
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(a.initialized, 1);
    EXPECT_EQ(a.finalized, 1);
}

TEST(PeriodicActivity, ThreadEndsWithItsLastActivity) {
    unsigned pid = 0;
    {
        PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.0071);
        ASSERT_TRUE(a.start());
        pid = a.thread()->getPid();
    }
    for (const os::threads::Info& info : os::threads::list()) EXPECT_NE(info.pid, pid);
    EXPECT_TRUE(PeriodicActivity(ORO_SCHED_OTHER, 0, 0.0071).start());
}

TEST(PeriodicActivity, StartAndStopFromSeveralThreads) {
    CountingRunner r;
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.0005, &r);
    std::vector<std::thread> threads;
    for (int t = 0; t < 3; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i < 300; ++i) a.start(), a.stop();
        });
    for (std::thread& thread : threads) thread.join();
    (void)a.stop();
    EXPECT_EQ(r.initialized, r.finalized);
}

TEST(PeriodicActivity, ActivitiesOfTwoThreadsMayStopEachOther) {
    CountingRunner first, second;
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.002, &first);
    PeriodicActivity b(ORO_SCHED_OTHER, 0, 0.003, &second);
    std::atomic<int> inside{0}, returned{0};
    const auto stopOther = [&](PeriodicActivity& other) {
        if (++inside > 2) return;
        eventually([&] { return inside >= 2; });
        other.stop();
        ++returned;
    };
    first.onStep = [&] { stopOther(b); };
    second.onStep = [&] { stopOther(a); };
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(b.start());
    // Each waits for the step of the other. At least one gives up, and nobody waits for ever.
    EXPECT_TRUE(eventually([&] { return returned == 2; }));
    EXPECT_TRUE(eventually([&] { return !a.isActive() || a.stop(); }));
    EXPECT_TRUE(eventually([&] { return !b.isActive() || b.stop(); }));
}

TEST(PeriodicActivity, StopGivesUpOnAStepThatDoesNotReturn) {
    const oroforge::test::LogCapture log;
    CountingRunner r;
    std::atomic<bool> inside{false}, leave{false};
    r.onStep = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.002, &r);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(a.stop());
    EXPECT_TRUE(a.isActive());
    EXPECT_TRUE(a.isRunning());
    EXPECT_EQ(log.count(3, "cannot stop a periodic activity"), 1);
    EXPECT_EQ(r.finalized, 0);
    leave = true;
    const int steps = r.steps;
    EXPECT_TRUE(eventually([&] { return r.steps > steps; }));
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(r.finalized, 1);
}

TEST(PeriodicActivity, MayRestartItselfInAThreadThatIsFull) {
    const extras::TimerThreadPtr thread(new TimerThread(ORO_SCHED_OTHER, 0, "full", 0.002));
    std::vector<std::unique_ptr<CountingRunner>> runners;
    std::vector<std::unique_ptr<PeriodicActivity>> activities;
    std::atomic<int> restarts{0};
    for (std::size_t i = 0; i < TimerThread::MAX_ACTIVITIES; ++i) {
        runners.emplace_back(new CountingRunner);
        activities.emplace_back(new PeriodicActivity(thread, runners.back().get()));
    }
    PeriodicActivity& restless = *activities[3];
    runners[3]->onStep = [&] {
        if (restless.stop() && restless.start()) ++restarts;
    };
    for (const auto& activity : activities) ASSERT_TRUE(activity->start());
    EXPECT_TRUE(eventually([&] { return restarts >= 3; }));
    EXPECT_TRUE(restless.isActive());
    for (const auto& activity : activities) EXPECT_TRUE(eventually([&] { return activity->stop(); }));
}

TEST(PeriodicActivity, IsExecutedByOneThreadOnly) {
    CountingRunner r;
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.002, &r);
    std::atomic<bool> self{false};
    r.onStep = [&] { self = a.isSelf(); };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return self.load(); }));
    EXPECT_FALSE(a.isSelf());
}

TEST(PeriodicActivity, IsActiveUntilStopHasWaited) {
    CountingRunner r;
    PeriodicActivity a(ORO_SCHED_OTHER, 0, 0.002, &r);
    oroforge::test::expectActiveUntilStopHasWaited(a, r.onStep, [&] { return !a.isRunning(); });
}
