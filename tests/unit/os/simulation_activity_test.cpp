// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/extras/FileDescriptorSimulationActivity.hpp>
#include <rtt/extras/SimulationActivity.hpp>
#include <rtt/os/TimeService.hpp>

#include <stdexcept>
#include <thread>

using namespace RTT;
using extras::FileDescriptorSimulationActivity;
using extras::SimulationActivity;
using extras::SimulationThread;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::LogCapture;

namespace {

struct SimulationTest : testing::Test {
    extras::SimulationThreadPtr thread = SimulationThread::Instance();
    os::TimeService& time = *os::TimeService::Instance();
    CountingRunner r;
    ~SimulationTest() override {
        eventually([&] { return !thread->isActive() || thread->stop(); });
        SimulationThread::Release();
    }
};

}  // namespace

TEST_F(SimulationTest, ThereIsOneThread) {
    EXPECT_EQ(SimulationThread::Instance(), thread);
    EXPECT_EQ(thread->getPeriod(), 0.001);
    EXPECT_EQ(thread->getScheduler(), ORO_SCHED_OTHER);
    EXPECT_FALSE(thread->isRunning());
    EXPECT_TRUE(SimulationThread::Release());
    EXPECT_FALSE(SimulationThread::Release());
    thread = SimulationThread::Instance(0.01);
    EXPECT_EQ(thread->getPeriod(), 0.01);
    EXPECT_EQ(SimulationThread::Instance()->getPeriod(), 0.01);
}

TEST_F(SimulationTest, RunMakesItsStepsInTheCaller) {
    SimulationActivity a(0.001, &r);
    bool self = false, clock = true;
    r.onStep = [&] {
        self = a.isSelf() && thread->isRunning() && a.isRunning();
        clock = time.systemClockEnabled();
    };
    EXPECT_TRUE(thread->run(3));
    EXPECT_EQ(r.steps, 0);  // not started
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.start());
    EXPECT_FALSE(thread->isActive());  // starting an activity makes no steps
    EXPECT_TRUE(thread->run(7));
    EXPECT_EQ(r.steps, 7);
    EXPECT_EQ(r.timeouts, 7);
    EXPECT_TRUE(self);
    EXPECT_FALSE(clock);
    EXPECT_TRUE(time.systemClockEnabled());
    EXPECT_TRUE(a.isSelf());  // the main thread, as long as nobody makes steps
    EXPECT_FALSE(thread->run(0));
    EXPECT_TRUE(a.stop());
    EXPECT_TRUE(thread->run(1));
    EXPECT_EQ(r.steps, 7);
    EXPECT_EQ(r.finalized, 1);
}

TEST_F(SimulationTest, EachStepMovesTheTimeByOnePeriod) {
    std::vector<nsecs> at;
    r.onStep = [&] { at.push_back(time.getNSecs()); };
    SimulationActivity a(0.001, &r);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(thread->run(100));
    ASSERT_EQ(at.size(), 100u);
    for (std::size_t i = 1; i < at.size(); ++i) EXPECT_EQ(at[i] - at[i - 1], 1000000);
    EXPECT_GE(time.getNSecs(), at.back() + 1000000);  // the clock goes on from there
}

TEST_F(SimulationTest, StartMakesStepsInItsOwnThread) {
    SimulationActivity a(0.001, &r);
    std::atomic<bool> inThread{false};
    r.onStep = [&] { inThread = thread->isSelf() && a.isSelf(); };
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(thread->start(0));
    ASSERT_TRUE(thread->start());
    EXPECT_FALSE(thread->start());
    EXPECT_FALSE(thread->run(1));
    EXPECT_TRUE(eventually([&] { return r.steps >= 5; }));
    EXPECT_TRUE(inThread);
    EXPECT_FALSE(time.systemClockEnabled());
    EXPECT_TRUE(eventually([&] { return thread->stop(); }));
    EXPECT_TRUE(time.systemClockEnabled());
}

TEST_F(SimulationTest, StartStopsByItselfAfterItsSteps) {
    SimulationActivity a(0.001, &r);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(thread->start(5));
    EXPECT_TRUE(eventually([&] { return !thread->isActive(); }));
    EXPECT_EQ(r.steps, 5);
    EXPECT_TRUE(time.systemClockEnabled());
    ASSERT_TRUE(thread->start(2));
    EXPECT_TRUE(eventually([&] { return !thread->isActive(); }));
    EXPECT_EQ(r.steps, 7);
}

TEST_F(SimulationTest, AnActivityMayEndTheRun) {
    SimulationActivity a(0.001, &r);
    r.onStep = [&] {
        EXPECT_FALSE(thread->run(1));
        EXPECT_FALSE(thread->start());
        if (r.steps == 4) {
            EXPECT_TRUE(thread->stop());
        }
    };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(thread->run(1000));
    EXPECT_EQ(r.steps, 4);
}

TEST_F(SimulationTest, ExecuteMakesOneStepWithoutMovingTheTime) {
    SimulationActivity a(0.001, &r);
    bool again = true, self = false;
    r.onStep = [&] {
        again = a.execute();
        self = a.isSelf();
    };
    EXPECT_FALSE(a.execute());
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.execute());
    EXPECT_EQ(r.steps, 1);
    EXPECT_EQ(r.timeouts, 1);
    EXPECT_FALSE(again);
    EXPECT_TRUE(self);
    EXPECT_TRUE(time.systemClockEnabled());
    EXPECT_FALSE(a.trigger());
    EXPECT_FALSE(a.timeout());
    EXPECT_FALSE(a.setPeriod(0.5));
}

TEST_F(SimulationTest, ExecuteAndStepsExcludeEachOther) {
    int inside = 0, most = 0;  // not atomic: one thread at a time
    r.onStep = [&] {
        most = std::max(most, ++inside);
        --inside;
    };
    SimulationActivity a(0.001, &r);
    ASSERT_TRUE(a.start());
    int accepted = 0;
    std::thread updates([&] {
        for (int i = 0; i < 2000; ++i) accepted += a.execute();  // refused during a step of the simulation
    });
    EXPECT_TRUE(thread->run(2000));
    updates.join();
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(most, 1);
    EXPECT_EQ(r.steps, 2000 + accepted);
}

TEST_F(SimulationTest, AnotherPeriodGivesAWarning) {
    const LogCapture log;
    SimulationActivity same(0, 1000000);
    EXPECT_EQ(log.count(4, ""), 0);
    SimulationActivity other(0.5);
    EXPECT_EQ(other.getPeriod(), 0.001);
    EXPECT_EQ(log.count(4, "cannot have a period of 0.5"), 1);
}

TEST_F(SimulationTest, AnExceptionStopsOnlyThatActivity) {
    CountingRunner bad;
    bad.onStep = [] { throw std::runtime_error("boom"); };
    SimulationActivity a(0.001, &bad), b(0.001, &r);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(b.start());
    EXPECT_TRUE(thread->run(3));
    EXPECT_FALSE(a.isActive());
    EXPECT_EQ(r.steps, 3);
    bad.onStep = nullptr;
    EXPECT_TRUE(a.start());
    EXPECT_TRUE(a.execute());
}

TEST_F(SimulationTest, StandInForFileDescriptorsNeverWatches) {
    FileDescriptorSimulationActivity a(5, &r, "a");
    FileDescriptorSimulationActivity b(ORO_SCHED_OTHER, 0, nullptr, "b");
    FileDescriptorSimulationActivity c(ORO_SCHED_OTHER, 0, 0.001, nullptr, "c");
    FileDescriptorSimulationActivity d(ORO_SCHED_OTHER, 0, 0.001, 0u, nullptr, "d");
    extras::FileDescriptorActivityInterface& io = a;
    io.watch(0);
    EXPECT_FALSE(io.isWatched(0));
    EXPECT_FALSE(io.isUpdated(0));
    EXPECT_FALSE(io.hasTimeout());
    EXPECT_FALSE(io.hasError());
    io.setTimeout(20);
    EXPECT_EQ(io.getTimeout_us(), 20000);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(thread->run(1));
    EXPECT_TRUE(io.hasTimeout());
    EXPECT_FALSE(io.isUpdated(0));
    a.work(base::RunnableInterface::IOReady);
    EXPECT_EQ(r.ios, 1);
    EXPECT_TRUE(io.isUpdated(0));
    EXPECT_FALSE(io.hasTimeout());
}
