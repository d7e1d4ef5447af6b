// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/Activity.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/MainThread.hpp>

#include <deque>
#include <memory>
#include <mutex>
#include <thread>

using namespace RTT;
using extras::SlaveActivity;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;

namespace {

/** What an engine does with messages. */
struct MessageRunner : CountingRunner {
    std::mutex mutex;
    std::deque<base::DisposableInterface*> queue;

    ~MessageRunner() override {
        for (base::DisposableInterface* message : queue) message->dispose();
    }
    bool process(base::DisposableInterface* message) override {
        {
            std::lock_guard<std::mutex> lock(mutex);
            queue.push_back(message);
        }
        return getActivity()->trigger();
    }
    void work(WorkReason) override {
        while (base::DisposableInterface* message = take()) message->executeAndDispose();
    }
    bool breakLoop() override { return true; }
    base::DisposableInterface* take() {
        std::lock_guard<std::mutex> lock(mutex);
        if (queue.empty()) return nullptr;
        base::DisposableInterface* const first = queue.front();
        queue.pop_front();
        return first;
    }
};

}  // namespace

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

TEST(SlaveActivity, MayDieWithItsTriggerInTheQueue) {
    MessageRunner masterRunner;
    Activity master(&masterRunner);
    masterRunner.onLoop = [&] { usleep(5000); };
    ASSERT_TRUE(master.start());
    {
        CountingRunner r;
        SlaveActivity a(&master, &r);
        ASSERT_TRUE(a.start());
        EXPECT_TRUE(a.trigger());
    }
    EXPECT_TRUE(master.trigger());
    EXPECT_TRUE(eventually([&] {
        std::lock_guard<std::mutex> lock(masterRunner.mutex);
        return masterRunner.queue.empty();
    }));
    EXPECT_TRUE(eventually([&] { return master.stop(); }));
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
