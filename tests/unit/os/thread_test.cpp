// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/os/MainThread.hpp>
#include <rtt/os/Thread.hpp>
#include <rtt/os/detail/scheduling.hpp>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <thread>

using namespace RTT;
using oroforge::test::eventually;

namespace {

struct TestThread : os::Thread {
    std::atomic<int> steps{0}, loops{0}, initialized{0}, finalized{0};
    std::function<void()> onLoop, onStep, onBreak, onFinalize;
    bool initializeResult = true;
    bool breakResult = true;

    explicit TestThread(Seconds period = 0.0, const std::string& name = "TestThread")
        : os::Thread(ORO_SCHED_OTHER, 0, period, 0, name) {}
    ~TestThread() override {
        stop();
        terminate();
    }
    bool initialize() override { return ++initialized, initializeResult; }
    void step() override {
        ++steps;
        if (onStep) onStep();
    }
    void loop() override {
        if (onLoop) onLoop();
        ++loops;
    }
    bool breakLoop() override {
        if (onBreak) onBreak();
        return breakResult;
    }
    void finalize() override {
        ++finalized;
        if (onFinalize) onFinalize();
    }
};

}  // namespace

TEST(Thread, NonPeriodicExecutesLoopOncePerStart) {
    TestThread t;
    EXPECT_FALSE(t.isActive());
    EXPECT_FALSE(t.stop());
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(t.isActive());
    EXPECT_TRUE(eventually([&] { return t.loops == 1 && !t.isRunning(); }));
    EXPECT_TRUE(t.isActive());
    EXPECT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return t.loops == 2; }));
    EXPECT_EQ(t.initialized, 1);
    EXPECT_TRUE(t.stop());
    EXPECT_EQ(t.finalized, 1);
    EXPECT_FALSE(t.isActive());
}

TEST(Thread, InitializeDecidesWhetherItStarts) {
    TestThread t;
    t.initializeResult = false;
    EXPECT_FALSE(t.start());
    EXPECT_FALSE(t.isActive());
    t.initializeResult = true;
    EXPECT_TRUE(t.start());
}

TEST(Thread, PeriodicStepsUntilStopped) {
    TestThread t(0.002);
    EXPECT_TRUE(t.isPeriodic());
    EXPECT_EQ(t.getPeriodNS(), 2000000);
    ASSERT_TRUE(t.start());
    EXPECT_FALSE(t.start());
    EXPECT_TRUE(t.isRunning());
    EXPECT_FALSE(t.setPeriod(0.0));  // not while active
    EXPECT_TRUE(eventually([&] { return t.steps >= 5; }));
    EXPECT_TRUE(t.stop());
    const int steps = t.steps;
    usleep(10000);
    EXPECT_EQ(t.steps, steps);
    EXPECT_EQ(t.loops, 0);
}

TEST(Thread, StopFailsIfBreakLoopRefuses) {
    TestThread t;
    std::atomic<bool> inside{false}, leave{false};
    t.breakResult = false;
    t.onLoop = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    ASSERT_TRUE(t.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(t.stop());
    EXPECT_TRUE(t.isActive());
    leave = true;
    t.breakResult = true;
    EXPECT_TRUE(t.stop());
}

TEST(Thread, StopGivesUpAfterItsTimeout) {
    TestThread t;
    std::atomic<bool> inside{false}, leave{false};
    t.onLoop = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    t.setStopTimeout(0.05);
    EXPECT_EQ(t.getStopTimeout(), 0.05);
    ASSERT_TRUE(t.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    const nsecs before = rtos_get_time_ns();
    EXPECT_FALSE(t.stop());
    EXPECT_GE(rtos_get_time_ns() - before, 50000000);
    EXPECT_TRUE(t.isActive());
    leave = true;
    t.setStopTimeout(10.0);
    EXPECT_TRUE(eventually([&] { return t.stop(); }));
    EXPECT_EQ(t.finalized, 1);
}

TEST(Thread, DefaultStopTimeoutDependsOnThePeriod) {
    EXPECT_EQ(TestThread().getStopTimeout(), 1.0);
    EXPECT_EQ(TestThread(0.1).getStopTimeout(), 1.0);
    EXPECT_EQ(TestThread(0.5).getStopTimeout(), 5.0);
}

TEST(Thread, MayStopItself) {
    TestThread t(0.001);
    t.onStep = [&] { t.stop(); };
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return !t.isActive(); }));
    EXPECT_EQ(t.finalized, 1);
    EXPECT_EQ(t.steps, 1);
    t.onStep = nullptr;
    EXPECT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return t.steps > 3; }));
}

TEST(Thread, ExceptionStopsTheThreadNotTheProcess) {
    TestThread t(0.001);
    t.onStep = [] { throw std::runtime_error("boom"); };
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return !t.isActive(); }));
    EXPECT_EQ(t.finalized, 1);
    t.onStep = [] { throw 42; };
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return !t.isActive(); }));
    EXPECT_FALSE(t.isRunning());
}

TEST(Thread, TooManyOverrunsStopIt) {
    TestThread t(0.001);
    t.onStep = [] { usleep(5000); };
    EXPECT_EQ(t.getMaxOverrun(), -1);
    t.setMaxOverrun(3);
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return !t.isActive(); }));
    EXPECT_EQ(t.finalized, 1);
    EXPECT_GE(t.steps, 3);
}

TEST(Thread, KnowsItself) {
    TestThread t;
    std::atomic<bool> self{false};
    t.onLoop = [&] { self = t.isSelf(); };
    EXPECT_FALSE(t.isSelf());
    t.start();
    EXPECT_TRUE(eventually([&] { return t.loops == 1; }));
    EXPECT_TRUE(self);
    EXPECT_TRUE(os::MainThread::Instance()->isSelf());
    std::thread([&] { EXPECT_FALSE(os::MainThread::Instance()->isSelf()); }).join();
}

TEST(Thread, CarriesAShortenedName) {
    EXPECT_EQ(os::detail::shortThreadName("fifteen_letters"), "fifteen_letters");
    EXPECT_EQ(os::detail::shortThreadName("a_rather_long_name"), "a_rathe~ng_name");
    TestThread t(0.0, "a_rather_long_name");
    EXPECT_STREQ(t.getName(), "a_rather_long_name");
    std::string name;
    std::ifstream("/proc/self/task/" + std::to_string(t.getPid()) + "/comm") >> name;
    EXPECT_EQ(name, "a_rathe~ng_name");
    EXPECT_STREQ(TestThread(0.0, "").getName(), "Thread");
}

TEST(Thread, IsListedWhileItExists) {
    const auto listed = [](unsigned pid) {
        const auto all = os::threads::list();
        return std::any_of(all.begin(), all.end(), [&](const os::threads::Info& i) { return i.pid == pid; });
    };
    unsigned pid = 0;
    {
        TestThread t;
        pid = t.getPid();
        EXPECT_TRUE(listed(pid));
        EXPECT_GE(t.threadNumber(), 0);
    }
    EXPECT_FALSE(listed(pid));
}

TEST(Thread, AffinityIsThatOfTheKernel) {
    TestThread t;
    const unsigned all = t.getCpuAffinity();
    const unsigned lowest = all & (~all + 1);
    EXPECT_TRUE(t.setCpuAffinity(lowest));
    EXPECT_EQ(t.getCpuAffinity(), lowest);
    EXPECT_TRUE(t.setCpuAffinity(0));
    EXPECT_EQ(t.getCpuAffinity(), all);
}

TEST(Thread, AnyPeriodMayBeSetWhileIdle) {
    TestThread t;
    EXPECT_TRUE(t.setPeriod(1, 500000000));
    EXPECT_EQ(t.getPeriod(), 1.5);
    EXPECT_TRUE(t.setPeriod(TIME_SPEC{0, 2000000}));
    EXPECT_EQ(t.getPeriodNS(), 2000000);
    EXPECT_FALSE(t.setPeriod(-1.0));
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(t.setPeriod(0.001));  // another period, still periodic
    EXPECT_TRUE(eventually([&] { return t.steps >= 3; }));
    EXPECT_EQ(t.loops, 0);
}

TEST(Thread, TooManyOverrunsAreReported) {
    const oroforge::test::LogCapture log;
    TestThread t(0.001, "late");
    t.onStep = [] { usleep(5000); };
    t.setMaxOverrun(2);
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return log.count(2, "setMaxOverrun()") == 1; }));
    EXPECT_EQ(log.count(2, "thread 'late' stopped: it has missed its period 2 times too often"), 1);
}

TEST(Thread, OverrunsAreCountedUnderTheRelativePolicyToo) {
    TestThread t(0.001);
    t.onStep = [] { usleep(5000); };
    t.setWaitPeriodPolicy(ORO_WAIT_REL);
    t.setMaxOverrun(3);
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return !t.isActive(); }));
}

TEST(Thread, ReportsItsCreation) {
    const oroforge::test::LogCapture log;
    TestThread t(0.25, "mine");
    EXPECT_EQ(log.count(5, "creating thread 'mine': ORO_SCHED_OTHER, priority 0, CPU mask 0"), 1);
    EXPECT_EQ(log.count(5, "created thread 'mine': ORO_SCHED_OTHER, priority 0"), 1);
    EXPECT_EQ(log.count(5, "period 0.25 s, PID " + std::to_string(t.getPid())), 1);
}

TEST(Thread, ReportsWhyItCannotBeStopped) {
    const oroforge::test::LogCapture log;
    TestThread t(0.0, "busy");
    std::atomic<bool> inside{false}, leave{false};
    t.breakResult = false;
    t.onLoop = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    t.setStopTimeout(0.02);
    ASSERT_TRUE(t.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(t.stop());
    EXPECT_EQ(log.count(4, "cannot stop thread 'busy': breakLoop() returned false"), 1);
    t.breakResult = true;
    EXPECT_FALSE(t.stop());
    EXPECT_EQ(log.count(3, "cannot stop thread 'busy': loop() or step() has not returned within 0.02 s"), 1);
    leave = true;
    t.setStopTimeout(20.0);
    EXPECT_TRUE(t.stop());
}

TEST(MainThread, IsAlwaysThere) {
    os::ThreadInterface* const thread = os::MainThread::Instance();
    EXPECT_STREQ(thread->getName(), "main");
    EXPECT_TRUE(thread->start());
    EXPECT_TRUE(thread->stop());
    EXPECT_TRUE(thread->isActive());
    EXPECT_TRUE(thread->isRunning());
    EXPECT_FALSE(thread->isPeriodic());
    EXPECT_EQ(thread->getPid(), static_cast<unsigned>(getpid()));
    EXPECT_EQ(thread->getScheduler(), sched_getscheduler(0));
    EXPECT_NE(thread->getCpuAffinity(), 0u);
    EXPECT_GE(thread->threadNumber(), 0);
}

TEST(Thread, AnExceptionInFinalizeDoesNotKeepItFromStopping) {
    const oroforge::test::LogCapture log;
    TestThread t(0.001, "mine");
    t.onFinalize = [] { throw std::runtime_error("boom"); };
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(t.stop());
    EXPECT_FALSE(t.isActive());
    EXPECT_EQ(log.count(2, "finalize() of thread 'mine' threw: boom"), 1);
    t.onFinalize = [] { throw 1; };
    t.onStep = [&] { t.stop(); };  // and from the thread itself
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return !t.isActive(); }));
    t.onStep = [] { throw 2; };  // and after an exception
    ASSERT_TRUE(eventually([&] { return t.start(); }));
    EXPECT_TRUE(eventually([&] { return !t.isActive(); }));
    EXPECT_EQ(t.finalized, 3);
    t.onStep = t.onFinalize = nullptr;
    EXPECT_TRUE(eventually([&] { return t.start(); }));
    EXPECT_TRUE(t.stop());
}

TEST(Thread, AnExceptionInBreakLoopIsARefusal) {
    const oroforge::test::LogCapture log;
    TestThread t(0.0, "mine");
    std::atomic<bool> inside{false}, leave{false};
    t.onBreak = [] { throw std::runtime_error("boom"); };
    t.onLoop = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    ASSERT_TRUE(t.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(t.stop());
    EXPECT_TRUE(t.isActive());
    EXPECT_EQ(log.count(2, "breakLoop() of thread 'mine' threw: boom"), 1);
    leave = true;
    t.onBreak = nullptr;
    EXPECT_TRUE(eventually([&] { return t.stop(); }));
}
