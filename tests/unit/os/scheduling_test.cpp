// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/Activity.hpp>
#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/os/Thread.hpp>
#include <rtt/os/detail/scheduling.hpp>

#include <fstream>
#include <linux/capability.h>
#include <new>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::LogCapture;

namespace {

/** What the process may do about real-time threads afterwards: priorities up to `limit`. */
bool dropPrivilege(rlim_t limit) {
    const rlimit both{limit, limit};
    if (setrlimit(RLIMIT_RTPRIO, &both) != 0) return false;
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct data[_LINUX_CAPABILITY_U32S_3] = {};
    return syscall(SYS_capset, &header, data) == 0;
}

/** Runs a check in a process of its own; true if it held there. */
bool inChild(const std::function<bool()>& check) {
    const pid_t child = fork();
    if (child == 0) _exit(check() ? 0 : 1);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool unprivileged(rlim_t limit, const std::function<bool()>& check) {
    return inChild([&] { return dropPrivilege(limit) && check(); });
}

/** Executes loop() once per start(). */
struct Counter : os::Thread {
    std::atomic<int> loops{0};
    Counter(int scheduler, int priority) : os::Thread(scheduler, priority, 0.0, 0, "counter") {}
    ~Counter() override {
        stop();
        terminate();
    }
    void loop() override { ++loops; }
};

}  // namespace

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
    EXPECT_FALSE(Counter(ORO_SCHED_OTHER, 0).setScheduler(77));
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

// Each in a child that has never been more than it says: a process cannot take its privileges back.

TEST(Scheduling, WithoutThePrivilegeOnlyAWarning) {
    EXPECT_TRUE(unprivileged(0, [] {
        const LogCapture log;
        Counter t(ORO_SCHED_RT, 50);
        return t.getScheduler() == ORO_SCHED_OTHER && t.getPriority() == 0 &&
               sched_getscheduler(static_cast<pid_t>(t.getPid())) == SCHED_OTHER &&
               log.count(4, "needs the capability CAP_SYS_NICE or an rtprio limit above 0, using ORO_SCHED_OTHER") ==
                   1 &&
               log.count(3, "") == 0 && t.start() && eventually([&] { return t.loops == 1; });
    }));
}

TEST(Scheduling, ActivitiesWorkWithoutThePrivilege) {
    EXPECT_TRUE(unprivileged(0, [] {
        oroforge::test::CountingRunner first, second;
        Activity a(50, 0.001, &first);
        extras::PeriodicActivity b(ORO_SCHED_RT, 50, 0.001, &second);
        extras::PeriodicActivity c(ORO_SCHED_RT, 50, 0.001);  // the same as asked for, so one thread
        return a.getScheduler() == ORO_SCHED_OTHER && b.thread() == c.thread() && a.start() && b.start() &&
               eventually([&] { return first.timeouts >= 2 && second.timeouts >= 2; });
    }));
}

TEST(Scheduling, WithoutThePrivilegeChangesAreRefused) {
    EXPECT_TRUE(unprivileged(0, [] {
        Counter t(ORO_SCHED_OTHER, 0);
        return !t.setScheduler(ORO_SCHED_RT) && t.getScheduler() == ORO_SCHED_OTHER &&
               t.setScheduler(ORO_SCHED_OTHER) && t.setPriority(20) && t.getPriority() == 0;
    }));
}

TEST(Scheduling, ThePriorityLimitOfTheUserIsKept) {
    if (!unprivileged(10, [] { return true; })) GTEST_SKIP() << "this process may not raise its own rtprio limit";
    EXPECT_TRUE(unprivileged(10, [] {
        const LogCapture log;
        int scheduler = ORO_SCHED_RT;
        int priority = 50;
        const bool asked = os::CheckScheduler(scheduler) && !os::CheckPriority(scheduler, priority);
        priority = 5;
        return asked && scheduler == ORO_SCHED_RT && priority == 5 && os::CheckPriority(scheduler, priority) &&
               log.count(4, "priority 50 is above the rtprio limit of this user, using 10") == 1;
    }));
}

TEST(Scheduling, RefusalByTheSystemGivesAnOrdinaryThread) {
    EXPECT_TRUE(unprivileged(0, [] {
        const LogCapture log;
        int scheduler = ORO_SCHED_RT;
        int priority = 99;
        pthread_t thread;
        const int error = os::detail::createThread(
            thread, scheduler, priority, 0, [](void*) -> void* { return nullptr; }, nullptr, "rt");
        return error == 0 && pthread_join(thread, nullptr) == 0 && scheduler == ORO_SCHED_OTHER && priority == 0 &&
               log.count(4, "thread 'rt': cannot have ORO_SCHED_RT with priority 99, using ORO_SCHED_OTHER") == 1;
    }));
}

TEST(Scheduling, UnknownSchedulersAreReported) {
    const LogCapture log;
    Counter t(77, 3);
    EXPECT_EQ(t.getScheduler(), ORO_SCHED_OTHER);
    EXPECT_EQ(log.count(3, "thread 'counter': unknown scheduler 77, expected ORO_SCHED_RT or ORO_SCHED_OTHER"), 1);
    EXPECT_EQ(log.count(4, "thread 'counter': priority 3 has no meaning for ORO_SCHED_OTHER, using 0"), 1);
    t.setPriority(7);
    EXPECT_EQ(log.count(4, "thread 'counter': priority 7 has no meaning for ORO_SCHED_OTHER, using 0"), 1);
    int scheduler = 88;
    EXPECT_FALSE(os::CheckScheduler(scheduler));
    EXPECT_EQ(log.count(3, "Thread: unknown scheduler 88"), 1);
    Counter lowest(ORO_SCHED_OTHER, os::LowestPriority);
    EXPECT_EQ(log.count(4, ""), 2);
}

#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)  // they need the memory themselves
TEST(Scheduling, AThreadThatCannotBeMadeThrows) {
    EXPECT_TRUE(inChild([] {
        const LogCapture log;
        long long pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlim_t bytes = static_cast<rlim_t>(pages) * 4096 + (64u << 20);
        const rlimit both{bytes, bytes};
        if (setrlimit(RLIMIT_AS, &both) != 0) return false;
        os::Thread::setStackSize(1u << 30);
        try {
            Counter t(ORO_SCHED_OTHER, 0);
        } catch (const std::bad_alloc&) {
            return log.count(2, "cannot create thread 'counter'") == 1;
        }
        return false;
    }));
}
#endif

TEST(Scheduling, EachThreadHasItsCPUs) {
    Counter t(ORO_SCHED_OTHER, 0);
    const unsigned all = t.getCpuAffinity();
    for (unsigned cpu = 0; cpu < 32; ++cpu) {
        if (!(all & (1u << cpu))) continue;
        Activity a(ORO_SCHED_OTHER, 0, 0.0, 1u << cpu, nullptr, "pinned");
        oroforge::test::CountingRunner r;
        std::atomic<int> ranOn{-1};
        r.onWork = [&](auto) { ranOn = sched_getcpu(); };
        ASSERT_TRUE(a.run(&r));
        ASSERT_TRUE(a.start());
        EXPECT_TRUE(eventually([&] { return ranOn == static_cast<int>(cpu); }));
        EXPECT_TRUE(a.setCpuAffinity(0));
        EXPECT_EQ(a.getCpuAffinity(), all);
        EXPECT_TRUE(a.stop());
    }
}

TEST(Scheduling, AMaskWithoutAnyCPUOfTheMachineIsRefusedWithAWarning) {
    Counter t(ORO_SCHED_OTHER, 0);
    const unsigned all = t.getCpuAffinity();
    if (all == ~0u) GTEST_SKIP() << "all CPUs of the mask exist";
    const unsigned highest = 1u << 31;
    if (all & highest) GTEST_SKIP() << "CPU 31 exists";
    const LogCapture log;
    EXPECT_FALSE(t.setCpuAffinity(highest));
    EXPECT_EQ(log.count(4, "thread 'counter': cannot use the CPU mask 2147483648"), 1);
    EXPECT_EQ(t.getCpuAffinity(), all);
}
