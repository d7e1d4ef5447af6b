// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Clock, atomics, wake-ups, real-time memory, logging that nobody sees.
#include <support/real_time_trap.hpp>

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/extras/FileDescriptorActivity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/os/Atomic.hpp>
#include <rtt/os/CAS.hpp>
#include <rtt/os/Condition.hpp>
#include <rtt/os/MainThread.hpp>
#include <rtt/os/Semaphore.hpp>
#include <rtt/os/real_time_thread.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/rt_list.hpp>
#include <rtt/rt_string.hpp>

#include <atomic>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

#include <unistd.h>

using namespace RTT;
using oroforge::test::expectRealTime;
using oroforge::test::RealTimeTrap;

namespace {

class RealTimeOs : public testing::Test {
protected:
    void SetUp() override {
        OROFORGE_NEEDS_REAL_TIME_TRAP();
        os::MainThread::Instance();  // as __os_init() does
    }
};

struct Idle : base::RunnableInterface {
    bool initialize() override { return true; }
    void step() override {}
    void loop() override {}
    void finalize() override {}
};

}  // namespace

TEST_F(RealTimeOs, TheClockIsRead) {
    os::TimeService* const clock = os::TimeService::Instance();
    double sum = 0;
    expectRealTime([&] {
        const os::TimeService::ticks start = os::TimeService::Instance()->getTicks();
        sum = clock->secondsSince(start) + clock->getSeconds() + static_cast<double>(clock->getNSecs(1));
        clock->enableSystemClock(false);
        clock->secondsChange(1.0);
        clock->ticksChange(5);
        clock->enableSystemClock(clock->systemClockEnabled());
        clock->enableSystemClock(true);
    });
    EXPECT_GT(sum, 0);
    os::TimeService::Release();
}

TEST_F(RealTimeOs, AtomicsSemaphoresAndBroadcasts) {
    os::AtomicInt atomic(1);
    int word = 1;
    os::Semaphore semaphore(0);
    os::Condition condition;
    expectRealTime([&] {
        atomic.inc();
        atomic.add(3);
        EXPECT_FALSE(atomic.dec_and_test());
        EXPECT_TRUE(os::CAS(&word, 1, 2));
        semaphore.signal();
        EXPECT_TRUE(semaphore.trywait());
        EXPECT_FALSE(semaphore.trywait());
        EXPECT_EQ(semaphore.value(), 0);
        condition.broadcast();
    });
}

TEST_F(RealTimeOs, ActivitiesAreTriggered) {
    Idle one, two;
    Activity own(0, 0.0, &one, "own");
    Activity periodic(0, 0.01, &two, "periodic");
    ASSERT_TRUE(own.start() && periodic.start());
    expectRealTime([&] {
        for (int i = 0; i < 10; ++i) {
            EXPECT_TRUE(own.trigger());
            EXPECT_TRUE(own.timeout());
            periodic.trigger();
            periodic.timeout();
        }
        EXPECT_FALSE(own.isSelf());
        EXPECT_FALSE(own.thread()->isSelf());
        EXPECT_TRUE(own.isActive());
        EXPECT_TRUE(periodic.isRunning() && periodic.isPeriodic() && periodic.getPeriod() > 0);
    });
    EXPECT_TRUE(own.stop() && periodic.stop());
}

TEST_F(RealTimeOs, ActivitiesOfFileDescriptorsAreTriggered) {
    Idle idle;
    extras::FileDescriptorActivity activity(ORO_SCHED_OTHER, 0, &idle, "files");
    ASSERT_TRUE(activity.start());
    expectRealTime([&] {
        for (int i = 0; i < 10; ++i) {
            EXPECT_TRUE(activity.trigger());
            EXPECT_TRUE(activity.timeout());
        }
    });
    EXPECT_TRUE(activity.stop());
}

TEST_F(RealTimeOs, ActivitiesWithoutAThreadAreExecuted) {
    Idle idle, slaved;
    extras::SequentialActivity sequential(&idle);
    extras::SlaveActivity slave(0.01, &slaved);
    ASSERT_TRUE(sequential.start() && slave.start());
    sequential.trigger();
    slave.execute();
    expectRealTime([&] {
        EXPECT_TRUE(sequential.trigger());
        EXPECT_TRUE(sequential.timeout());
        EXPECT_TRUE(slave.execute());
        (void)(slave.isSelf() || sequential.isSelf());
    });
    EXPECT_TRUE(sequential.stop() && slave.stop());
}

TEST_F(RealTimeOs, ThreadsAreToldApart) {
    os::ThreadInterface* const main = os::MainThread::Instance();
    EXPECT_TRUE(main->isSelf());
    expectRealTime([&] { EXPECT_TRUE(main->isSelf()); });
}

TEST_F(RealTimeOs, ReaderSectionsAreEntered) {
    { internal::Reclaimer::Guard first; }
    int called = 0;
    expectRealTime([&] {
        internal::Reclaimer::Guard outer;
        internal::Reclaimer::Guard inner;
        EXPECT_TRUE(internal::Reclaimer::deferred().add(
            nullptr, [](void*& count) { ++*static_cast<int*>(count); }, &called));
    });
    EXPECT_EQ(called, 1);
}

// Its mutex is the one lock: it inherits priority and is held for a bounded number of instructions.
TEST_F(RealTimeOs, RealTimeMemoryComesFromItsPoolOnly) {
    oro_rt_free(oro_rt_malloc(1));
    const unsigned all = RealTimeTrap::kEverything;
    expectRealTime(
        [] {
            rt_list<rt_string> list;
            for (int i = 0; i < 50; ++i) list.push_back(rt_string(100, 'x'));
            list.front() += list.back();
            void* block = oro_rt_realloc(oro_rt_calloc(10, 10), 5000);
            EXPECT_NE(block, nullptr);
            oro_rt_free(block);
        },
        all & ~unsigned(RealTimeTrap::kLock));
}

TEST_F(RealTimeOs, LinesBelowTheLevelAreNotMade) {
    log(Debug) << "first use in this thread" << endlog();
    const std::string text(100, 'x');
    expectRealTime([&] { log(Debug) << "a message " << text << 3.5 << 7 << endlog(); });
}

// Where each thread has a record to announce that it uses ports: there are some in advance, the others are made.
TEST_F(RealTimeOs, AThreadUsesPortsForTheFirstTimeHoweverManyThereAre) {
    struct FirstUse : Idle {
        void loop() override {
            realTime = os::inRealTimeThread();
            if (realTime && !done) expectRealTime([] { const internal::Reclaimer::Guard inside; });
            done = true;
        }
        std::atomic<bool> done{false}, realTime{false};
    };
    std::atomic<bool> end{false};
    std::atomic<int> attached{0};
    std::vector<std::thread> others;
    for (int i = 0; i < 80; ++i)
        others.emplace_back([&] {
            { const internal::Reclaimer::Guard inside; }
            ++attached;
            while (!end) usleep(1000);
        });
    while (attached < 80) usleep(100);
    FirstUse runner;
    Activity activity(ORO_SCHED_RT, 1, 0.0, &runner, "first_use");
    EXPECT_TRUE(activity.start() && activity.trigger());
    for (int i = 0; i < 20000 && !runner.done; ++i) usleep(1000);
    EXPECT_TRUE(runner.done);
    activity.stop();
    end = true;
    for (std::thread& other : others) other.join();
    if (!runner.realTime) GTEST_SKIP() << "this process may not have real-time threads";
}
