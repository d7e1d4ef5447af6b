// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "activity_stop.hpp"
#include "message_runner.hpp"

#include <rtt/Activity.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/MainThread.hpp>

#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>

using namespace RTT;
using extras::SlaveActivity;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::MessageRunner;

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

TEST(SlaveActivity, OutlivesItsMaster) {
    const oroforge::test::LogCapture log;
    CountingRunner r;
    MessageRunner masterRunner;
    auto master = std::make_unique<Activity>(ORO_SCHED_OTHER, 0, 0.25, &masterRunner);
    SlaveActivity a(master.get(), &r);
    SlaveActivity slaveOfSlave(&a);
    ASSERT_TRUE(master->start());
    ASSERT_TRUE(a.start());
    master.reset();
    EXPECT_TRUE(a.isActive());
    EXPECT_TRUE(a.execute());
    EXPECT_EQ(r.steps, 1);
    EXPECT_FALSE(a.trigger());
    EXPECT_FALSE(a.timeout());
    EXPECT_EQ(a.getPeriod(), 0.25);  // what it was when the slave was made
    EXPECT_EQ(a.getCpuAffinity(), ~0u);
    EXPECT_EQ(a.thread(), os::MainThread::Instance());
    EXPECT_TRUE(a.isSelf());  // the main thread, which executed it last
    EXPECT_FALSE(slaveOfSlave.trigger());
    EXPECT_EQ(slaveOfSlave.getPeriod(), 0.25);
    EXPECT_TRUE(a.stop());
    EXPECT_FALSE(a.start());
    EXPECT_EQ(log.count(3, "its master is not active, or has been destroyed"), 1);
}

TEST(SlaveActivity, OutlivesAMasterOfTheUsersOwnKind) {
    struct Own : base::ActivityInterface {
        bool start() override { return true; }
        bool stop() override { return true; }
        bool isRunning() const override { return true; }
        bool isActive() const override { return true; }
        Seconds getPeriod() const override { return 0.0; }
        bool setPeriod(Seconds) override { return false; }
        unsigned getCpuAffinity() const override { return 2u; }
        bool setCpuAffinity(unsigned) override { return false; }
        bool execute() override { return false; }
        bool trigger() override { return true; }
        bool timeout() override { return true; }
        os::ThreadInterface* thread() override { return os::MainThread::Instance(); }
    };
    auto master = std::make_unique<Own>();
    SlaveActivity a(master.get());
    EXPECT_EQ(a.getCpuAffinity(), 2u);
    EXPECT_TRUE(a.start());
    master.reset();
    EXPECT_EQ(a.getCpuAffinity(), ~0u);
    EXPECT_FALSE(a.timeout());
}

TEST(SlaveActivity, MayDestroyItsMasterWithinATrigger) {
    MessageRunner masterRunner;
    struct Breaker : base::DisposableInterface {
        std::function<void()> action;
        void executeAndDispose() override { action(); }
        void dispose() override {}
    } breaker;
    auto other = std::make_unique<extras::SequentialActivity>(&masterRunner);
    SlaveActivity a(other.get());
    ASSERT_TRUE(other->start());
    ASSERT_TRUE(a.start());
    // What the sequential master executes in this thread takes its own runner away, within the trigger of the slave.
    breaker.action = [&] {
        other->stop();
        EXPECT_TRUE(other->run(nullptr));
    };
    masterRunner.queue.push_back(&breaker);
    EXPECT_TRUE(a.trigger());
    EXPECT_EQ(other->getRunner(), nullptr);
    EXPECT_FALSE(a.trigger());
}

TEST(SlaveActivity, StopWaitsForAnExecutionInAnotherThread) {
    CountingRunner r;
    std::atomic<bool> inside{false}, left{false};
    r.onLoop = [&] {
        inside = true;
        usleep(30000);
        left = true;
    };
    bool leftAtFinalize = false;
    r.onFinalize = [&] { leftAtFinalize = left; };
    SlaveActivity a(&r);
    ASSERT_TRUE(a.start());
    std::thread updates([&] { a.execute(); });
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_TRUE(a.stop());
    EXPECT_TRUE(leftAtFinalize);
    updates.join();
    EXPECT_EQ(r.finalized, 1);
}

TEST(SlaveActivity, MayBeStoppedFromWithin) {
    CountingRunner r;
    SlaveActivity a(&r);
    r.onLoop = [&] { EXPECT_TRUE(a.stop()); };
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.execute());
    EXPECT_FALSE(a.isActive());
    EXPECT_EQ(r.finalized, 1);
}

TEST(SlaveActivity, AnExceptionReachesTheCallerAndFreesIt) {
    CountingRunner r;
    SlaveActivity a(&r);
    ASSERT_TRUE(a.start());
    r.onLoop = [] { throw std::runtime_error("boom"); };
    EXPECT_THROW(a.execute(), std::runtime_error);
    r.onLoop = nullptr;
    EXPECT_TRUE(a.execute());
    EXPECT_EQ(r.timeouts, 1);
}

TEST(SlaveActivity, MasterDestroyedWhileItIsUsed) {
    for (int i = 0; i < 100; ++i) {
        CountingRunner r;
        MessageRunner masterRunner;
        auto master = std::make_unique<Activity>(&masterRunner);
        SlaveActivity a(master.get(), &r);
        ASSERT_TRUE(master->start());
        ASSERT_TRUE(a.start());
        std::atomic<int> refused{0};
        std::thread user([&] {
            while (refused < 3)
                if (!a.trigger()) ++refused;
        });
        std::thread asker([&] {
            while (refused < 3) (void)(a.isSelf() || a.getPeriod() < 0 || a.timeout());
        });
        master.reset();
        user.join();
        asker.join();
        EXPECT_TRUE(a.stop());
    }
}

TEST(SlaveActivity, ATriggerThatThrowsFreesIt) {
    MessageRunner masterRunner;
    Activity master(&masterRunner);
    CountingRunner r;
    r.onWork = [](auto reason) {
        if (reason == base::RunnableInterface::Trigger) throw std::runtime_error("boom");
    };
    SlaveActivity a(&master, &r);
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return r.triggers == 1 && !master.isActive(); }));
    EXPECT_TRUE(eventually([&] { return a.execute(); }));
    EXPECT_TRUE(a.stop());
}

TEST(SlaveActivity, StopWaitsForOneThatStoppedItself) {
    CountingRunner r;
    SlaveActivity a(&r);
    oroforge::test::expectStopWaitsForOneThatStoppedItself(a, r.onLoop, [&] { a.execute(); });
}

TEST(SlaveActivity, IsActiveUntilStopHasWaited) {
    CountingRunner r;
    SlaveActivity a(&r);
    oroforge::test::expectActiveUntilStopHasWaited(
        a, r.onLoop, [&] { return !a.isRunning(); }, [&] { a.execute(); });
}
