// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/os/MainThread.hpp>
#include <rtt/os/Thread.hpp>
#include <rtt/os/detail/scheduling.hpp>

#include <algorithm>
#include <fstream>
#include <linux/capability.h>
#include <stdexcept>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>

using namespace RTT;
using oroforge::test::eventually;

namespace {

struct TestThread : os::Thread {
    std::atomic<int> steps{0}, loops{0}, initialized{0}, finalized{0};
    std::function<void()> onLoop, onStep;
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
    bool breakLoop() override { return breakResult; }
    void finalize() override { ++finalized; }
};

bool dropPrivilege() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct data[_LINUX_CAPABILITY_U32S_3] = {};
    return syscall(SYS_capset, &header, data) == 0;
}

/** Runs a check in a process of its own without privileges; true if it held there. */
bool unprivileged(std::function<bool()> check) {
    const pid_t child = fork();
    if (child == 0) _exit(dropPrivilege() && check() ? 0 : 1);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

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

TEST(Scheduling, ValuesAreForcedIntoRange) {
    int scheduler = 77;
    EXPECT_FALSE(os::CheckScheduler(scheduler));
    EXPECT_EQ(scheduler, ORO_SCHED_OTHER);
    int priority = 20;
    EXPECT_FALSE(os::CheckPriority(scheduler, priority));
    EXPECT_EQ(priority, 0);
    EXPECT_TRUE(os::CheckPriority(scheduler, priority));
    scheduler = ORO_SCHED_RT;
    EXPECT_FALSE(os::CheckPriority(scheduler, priority));
    EXPECT_EQ(priority, 1);
    EXPECT_FALSE(TestThread().setScheduler(77));
}

TEST(Scheduling, RealTimeIsUsedWhereAllowed) {
    int scheduler = ORO_SCHED_RT;
    if (!os::CheckScheduler(scheduler)) GTEST_SKIP() << "no privilege to use ORO_SCHED_RT";
    os::Thread t(ORO_SCHED_RT, 150, 0.0, 0, "rt");
    EXPECT_EQ(t.getScheduler(), sched_getscheduler(static_cast<pid_t>(t.getPid())));
    if (t.getScheduler() != ORO_SCHED_RT) GTEST_SKIP() << "the system refuses ORO_SCHED_RT";
    EXPECT_LE(t.getPriority(), os::HighestPriority);
    EXPECT_TRUE(t.setPriority(5));
    EXPECT_EQ(t.getPriority(), 5);
    EXPECT_TRUE(t.setScheduler(ORO_SCHED_OTHER));
    EXPECT_EQ(sched_getscheduler(static_cast<pid_t>(t.getPid())), SCHED_OTHER);
    EXPECT_EQ(t.getPriority(), 0);
}

TEST(Scheduling, WithoutThePrivilegeOnlyAWarning) {
    EXPECT_TRUE(unprivileged([] {
        int scheduler = ORO_SCHED_RT;
        if (os::CheckScheduler(scheduler)) return true;  // this user has an rtprio limit
        os::Thread t(ORO_SCHED_RT, 50, 0.0, 0, "rt");
        return t.getScheduler() == ORO_SCHED_OTHER && t.getPriority() == 0;
    }));
}

TEST(Scheduling, RefusalByTheSystemGivesAnOrdinaryThread) {
    EXPECT_TRUE(unprivileged([] {
        int scheduler = ORO_SCHED_RT;
        int priority = 99;
        pthread_t thread;
        const int error = os::detail::createThread(
            thread, scheduler, priority, 0, [](void*) -> void* { return nullptr; }, nullptr, "rt");
        return error == 0 && pthread_join(thread, nullptr) == 0 && scheduler == ORO_SCHED_OTHER && priority == 0;
    }));
}
