// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "file_descriptor_test.hpp"

#include <stdexcept>

using namespace RTT;
using extras::FileDescriptorActivity;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::FileDescriptorActivityTest;
using oroforge::test::LogCapture;
using oroforge::test::Pipe;

TEST(FileDescriptorActivity, ConstructorsAreThoseOfTheOriginal) {
    EXPECT_STREQ(FileDescriptorActivity(5).getName(), "FileDescriptorActivity");
    EXPECT_EQ(FileDescriptorActivity(ORO_SCHED_OTHER, 0).getPeriod(), 0.0);
    FileDescriptorActivity nominal(ORO_SCHED_OTHER, 0, 0.25);
    EXPECT_EQ(nominal.getPeriod(), 0.25);
    EXPECT_EQ(nominal.getPeriodNS(), 250000000);
    EXPECT_FALSE(nominal.isPeriodic());
    FileDescriptorActivity pinned(ORO_SCHED_OTHER, 0, 0.0, 1u, nullptr, "pinned");
    EXPECT_EQ(pinned.getCpuAffinity(), 1u);
    EXPECT_STREQ(pinned.getName(), "pinned");
}

TEST(FileDescriptorActivity, ReportsItsNominalPeriodWhenItIsCreated) {
    const LogCapture log;
    FileDescriptorActivity nominal(ORO_SCHED_OTHER, 0, 0.02);
    EXPECT_EQ(log.count(5, "period 0.02 s, PID " + std::to_string(nominal.getPid())), 1);
}

TEST_F(FileDescriptorActivityTest, IsNotRunBeforeStartNorAfterStop) {
    a.watch(pipe.read);
    ASSERT_TRUE(pipe.put());
    EXPECT_FALSE(a.trigger());
    EXPECT_FALSE(a.timeout());
    EXPECT_FALSE(a.execute());
    EXPECT_FALSE(a.stop());
    usleep(5000);
    EXPECT_EQ(r.steps + r.triggers + r.ios, 0);
    ASSERT_TRUE(a.start());
    EXPECT_FALSE(a.start());
    EXPECT_TRUE(a.isActive());
    EXPECT_TRUE(eventually([&] { return r.ios + r.triggers >= 1 && taken == 1; }));
    EXPECT_TRUE(a.stop());
    const int works = r.ios + r.triggers;
    ASSERT_TRUE(pipe.put());
    usleep(5000);
    EXPECT_EQ(r.ios + r.triggers, works);
    EXPECT_EQ(r.initialized, 1);
    EXPECT_EQ(r.finalized, 1);
    EXPECT_FALSE(a.isRunning());
}

TEST_F(FileDescriptorActivityTest, ExecutesIOReadyWhenADescriptorIsReadable) {
    startIdle();
    a.watch(pipe.read);
    EXPECT_TRUE(a.isWatched(pipe.read));
    EXPECT_FALSE(a.isWatched(pipe.write));
    for (int i = 1; i <= 3; ++i) {
        ASSERT_TRUE(pipe.put());
        EXPECT_TRUE(eventually([&] { return taken == i; }));
    }
    // What follows in the last step comes a moment later.
    EXPECT_TRUE(eventually([&] { return r.ios == 3 && r.steps == 3 && updated == 3; }))
        << r.ios << ' ' << r.steps << ' ' << updated;
    EXPECT_EQ(hadTimeout, 0);
    EXPECT_EQ(r.loops, 0);
}

TEST_F(FileDescriptorActivityTest, TriggerAndTimeoutHaveTheirOwnReasons) {
    startIdle();
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return r.triggers == 2; }));
    EXPECT_FALSE(a.hasTimeout());
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(eventually([&] { return r.timeouts == 1; }));
    EXPECT_TRUE(eventually([&] { return !a.isRunning(); }));
    EXPECT_EQ(hadTimeout, 0);  // it was asked for, no time was over
    EXPECT_EQ(r.steps, 2);
    EXPECT_EQ(r.ios, 0);
}

TEST_F(FileDescriptorActivityTest, IsRunningOnlyWhileItExecutes) {
    std::atomic<int> running{0};
    r.onStep = [&] { running += a.isRunning(); };
    EXPECT_FALSE(a.isRunning());
    startIdle();
    EXPECT_TRUE(eventually([&] { return !a.isRunning(); }));
    EXPECT_TRUE(a.isActive());
    a.watch(pipe.read);
    ASSERT_TRUE(pipe.put());
    EXPECT_TRUE(eventually([&] { return running == 1 && !a.isRunning(); }));
    r.onStep = [] { throw std::runtime_error("boom"); };
    a.trigger();
    EXPECT_TRUE(eventually([&] { return !a.isActive(); }));
    EXPECT_FALSE(a.isRunning());
    r.onStep = nullptr;
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return !a.isRunning(); }));
}

TEST_F(FileDescriptorActivityTest, ALongStepIsNoTimeout) {
    a.setTimeout(20);
    r.onStep = [&] {
        if (r.steps == 1) usleep(60000);
    };
    startIdle();
    a.watch(pipe.read);
    ASSERT_TRUE(pipe.put());
    ASSERT_TRUE(eventually([&] { return taken == 1; }));
    ASSERT_TRUE(pipe.put());
    ASSERT_TRUE(eventually([&] { return taken == 2; }));
    EXPECT_EQ(hadTimeout, 0);
    EXPECT_EQ(r.timeouts, 0);
    EXPECT_TRUE(eventually([&] { return hadTimeout >= 1; }));
}

TEST_F(FileDescriptorActivityTest, InputAfterTheTimeIsNoTimeout) {
    std::atomic<bool> put{false};
    r.onStep = [&] {
        if (r.steps != 1) return;
        put = pipe.put() && pipe.put();  // one for this step
        usleep(350000);
    };
    a.setTimeout(300);
    startIdle();
    a.watch(pipe.read);
    ASSERT_TRUE(a.trigger());  // does not postpone the time, which is over when the step is
    ASSERT_TRUE(eventually([&] { return taken == 2; }));
    EXPECT_TRUE(put);
    EXPECT_EQ(r.ios, 1);
    EXPECT_EQ(hadTimeout, 0);
}

TEST_F(FileDescriptorActivityTest, NominalPeriodDoesNotDriveIt) {
    EXPECT_FALSE(a.setPeriod(-1.0));
    EXPECT_TRUE(a.setPeriod(0.001));
    startIdle();
    usleep(20000);
    EXPECT_EQ(r.steps, 0);
    EXPECT_EQ(a.getPeriod(), 0.001);
    EXPECT_TRUE(a.timeout());  // nor does it turn this off
    EXPECT_TRUE(eventually([&] { return r.timeouts == 1; }));
    EXPECT_TRUE(a.setPeriod(0.0));
}

TEST_F(FileDescriptorActivityTest, ATimeWithoutInputIsATimeoutAndNoError) {
    const LogCapture log;
    a.setTimeout(3);
    EXPECT_EQ(a.getTimeout(), 3);
    EXPECT_EQ(a.getTimeout_us(), 3000);
    const nsecs before = rtos_get_time_ns();
    startIdle();
    EXPECT_TRUE(eventually([&] { return hadTimeout >= 3; }));
    EXPECT_GE(rtos_get_time_ns() - before, 9000000);
    EXPECT_EQ(r.ios, 0);
    EXPECT_EQ(hadError, 0);
    EXPECT_EQ(log.count(3, ""), 0);
    a.setTimeout(0);  // none from now on, also for the wait that has begun
    ASSERT_TRUE(a.trigger());
    ASSERT_TRUE(eventually([&] { return r.triggers == 2; }));  // so it has seen the new time
    const int timeouts = r.timeouts;
    usleep(10000);
    EXPECT_EQ(r.timeouts, timeouts);
}

TEST_F(FileDescriptorActivityTest, TheTimeMayBeSetWhileItWaits) {
    startIdle();
    a.setTimeout(100000000);  // more microseconds than an int holds
    EXPECT_EQ(a.getTimeout(), 100000000);
    a.setTimeout_us(500);
    EXPECT_EQ(a.getTimeout_us(), 500);
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 2; }));
}

TEST_F(FileDescriptorActivityTest, TriggersDoNotStarveTheTimeout) {
    a.setTimeout(20);
    startIdle();
    EXPECT_TRUE(eventually([&] { return a.trigger() && r.timeouts >= 2; }));
    EXPECT_GT(r.triggers, 2);
}

TEST_F(FileDescriptorActivityTest, MayStopAndRestartItself) {
    std::atomic<bool> done{false};
    r.onStep = [&] {
        if (done.exchange(true)) return;
        EXPECT_TRUE(a.stop());
        EXPECT_FALSE(a.isActive());
        EXPECT_TRUE(a.start());
    };
    startIdle();
    a.watch(pipe.read);
    a.trigger();
    EXPECT_TRUE(eventually([&] { return r.initialized == 2 && r.triggers >= 3; }));
    ASSERT_TRUE(pipe.put());
    EXPECT_TRUE(eventually([&] { return taken == 1; }));
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(r.finalized, 2);
}

TEST_F(FileDescriptorActivityTest, StartForgetsWhatCameBefore) {
    a.setTimeout(2);
    startIdle();
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 1; }));
    a.setTimeout(0);
    EXPECT_TRUE(a.stop());
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.triggers == 2; }));
    EXPECT_FALSE(a.hasTimeout());
}

TEST_F(FileDescriptorActivityTest, AnExceptionStopsIt) {
    r.onStep = [] { throw std::runtime_error("boom"); };
    startIdle();
    a.trigger();
    EXPECT_TRUE(eventually([&] { return !a.isActive(); }));
    EXPECT_EQ(r.finalized, 1);
    r.onStep = nullptr;
    EXPECT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.triggers == 2; }));
}

TEST_F(FileDescriptorActivityTest, StopGivesUpOnAStepThatDoesNotReturn) {
    std::atomic<bool> inside{false}, leave{false};
    r.onStep = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    a.setStopTimeout(0.02);
    startIdle();
    a.trigger();
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(a.stop());
    EXPECT_TRUE(a.isActive());
    leave = true;
    a.setStopTimeout(20.0);
    const int triggers = r.triggers;
    a.trigger();
    EXPECT_TRUE(eventually([&] { return r.triggers > triggers; }));
    EXPECT_TRUE(a.stop());
}

TEST(FileDescriptorActivity, MayBeDestroyedWhileAStepDoesNotReturn) {
    CountingRunner r;
    std::atomic<bool> inside{false};
    r.onStep = [&] {
        inside = true;
        usleep(50000);
    };
    {
        FileDescriptorActivity a(ORO_SCHED_OTHER, 0, &r);
        a.setStopTimeout(0.001);
        ASSERT_TRUE(a.start());
        a.trigger();
        ASSERT_TRUE(eventually([&] { return inside.load(); }));
    }
    EXPECT_EQ(r.getActivity(), nullptr);
}

TEST(FileDescriptorActivity, SubClassMayReplaceTheRunner) {
    struct Reader : FileDescriptorActivity {
        std::atomic<int> steps{0}, works{0};
        Reader() : FileDescriptorActivity(ORO_SCHED_OTHER, 0, nullptr, "Reader") {}
        ~Reader() override { stop(); }
        void step() override { ++steps; }
        void work(base::RunnableInterface::WorkReason reason) override {
            if (reason == base::RunnableInterface::IOReady) ++works;
        }
    } a;
    Pipe pipe;
    a.watch(pipe.read);
    ASSERT_TRUE(pipe.put());
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return a.works >= 1 && a.steps >= 1; }));
    extras::FileDescriptorActivityInterface* const io =
        dynamic_cast<extras::FileDescriptorActivityInterface*>(static_cast<base::ActivityInterface*>(&a));
    ASSERT_NE(io, nullptr);
    EXPECT_TRUE(io->isWatched(pipe.read));
}
