// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Activities as users write them: sub-classes that replace what the runtime's execute, used from several threads.
#include "file_descriptor_test.hpp"
#include "together.hpp"

#include <rtt/RTT.hpp>
#include <rtt/extras/Activities.hpp>
#include <rtt/os/MutexLock.hpp>

#include <deque>
#include <memory>
#include <thread>

using namespace RTT;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::kThreads;
using oroforge::test::Pipe;
using oroforge::test::together;

namespace {

/** What a transport does that publishes in a thread of its own: others hand it work and trigger it. */
class PublishActivity : public RTT::Activity {
public:
    PublishActivity(int priority, const std::string& name)
        : RTT::Activity(ORO_SCHED_OTHER, priority, 0.0, nullptr, name) {
        Logger::In in("PublishActivity");
    }
    ~PublishActivity() override { stop(); }

    void loop() override {
        for (std::deque<int> work = take(); !work.empty(); work = take())
            for (const int n : work) sum += n;
        ++loops;
    }
    bool breakLoop() override { return true; }
    void publish(int n) {
        {
            os::MutexLock lock(mutex_);
            queue_.push_back(n);
        }
        trigger();
    }
    std::atomic<long> sum{0};
    std::atomic<int> loops{0};

private:
    std::deque<int> take() {
        os::MutexLock lock(mutex_);
        std::deque<int> taken;
        taken.swap(queue_);
        return taken;
    }
    os::Mutex mutex_;
    std::deque<int> queue_;
};

TEST(UserActivity, PublisherLosesNothingOfSeveralThreads) {
    PublishActivity publisher(os::LowestPriority, "publisher");
    ASSERT_TRUE(publisher.start());
    together([&](int) {
        for (int i = 1; i <= 2000; ++i) publisher.publish(i);
    });
    EXPECT_TRUE(eventually([&] { return publisher.sum == kThreads * 2001000L; }));
    EXPECT_TRUE(publisher.stop());
}

/** Blocks in loop() until it is broken, as one that reads from a device. */
class DeviceActivity : public RTT::Activity {
public:
    DeviceActivity() : RTT::Activity(ORO_SCHED_OTHER, os::LowestPriority) {}
    ~DeviceActivity() override { stop(); }
    bool initialize() override { return ++initialized, quit = false, open; }
    void loop() override {
        inside = true;
        eventually([&] { return quit.load(); });
        inside = false;
    }
    bool breakLoop() override { return quit = true, true; }
    void finalize() override { ++finalized; }
    std::atomic<bool> open{true}, quit{false}, inside{false};
    std::atomic<int> initialized{0}, finalized{0};
};

TEST(UserActivity, DeviceIsStoppedInItsLoop) {
    DeviceActivity device;
    device.open = false;
    EXPECT_FALSE(device.start());
    device.open = true;
    for (int i = 0; i != 20; ++i) {
        ASSERT_TRUE(device.start());
        if (i % 2) {
            ASSERT_TRUE(eventually([&] { return device.inside.load(); }));
        }
        ASSERT_TRUE(device.stop());
        EXPECT_FALSE(device.inside);
    }
    EXPECT_EQ(device.initialized, 21);
    EXPECT_EQ(device.finalized, 20);
    ASSERT_TRUE(device.start());  // and destroyed while it runs
}

TEST(UserActivity, DeviceIsStartedAndStoppedBySeveralThreads) {
    DeviceActivity device;
    device.setStopTimeout(20.0);
    std::atomic<int> stops{0};
    together([&](int t) {
        for (int i = 0; i != 100; ++i) {
            device.start();
            device.trigger();
            if (t % 2) device.timeout();
            stops += device.stop();
        }
    });
    stops += device.stop();
    EXPECT_FALSE(device.isActive());
    EXPECT_EQ(device.finalized, device.initialized);
    EXPECT_EQ(device.finalized, stops);
}

/** A periodic one that counts its wake-ups by their reason and asks its runner for work. */
class ScheduleActivity : public RTT::Activity {
public:
    ScheduleActivity(Seconds period, base::RunnableInterface* r)
        : RTT::Activity(ORO_SCHED_OTHER, 0, period, 0, r, "Schedule") {}
    ~ScheduleActivity() override { stop(); }
    bool initialize() override { return RTT::Activity::initialize(); }
    void step() override {
        ++steps;
        RTT::Activity::step();
    }
    void work(base::RunnableInterface::WorkReason reason) override {
        ++(reason == base::RunnableInterface::TimeOut ? timeouts : triggers);
        if (getRunner()->hasWork()) ++found;
        RTT::Activity::work(reason);
    }
    std::atomic<int> steps{0}, timeouts{0}, triggers{0}, found{0};
};

TEST(UserActivity, SeesEachWakeUpOfItsRunner) {
    CountingRunner r;
    r.hasWorkResult = true;
    ScheduleActivity a(0.002, &r);
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return a.timeouts >= 3; }));
    together([&](int) {
        for (int i = 0; i != 50; ++i) EXPECT_TRUE(a.trigger());
    });
    // One wake-up may serve all of those.
    EXPECT_TRUE(eventually([&] { return a.trigger() && a.triggers >= 2; }));
    EXPECT_TRUE(a.setPeriod(0.0));
    EXPECT_TRUE(a.timeout());
    EXPECT_TRUE(eventually([&] { return a.stop(); }));
    EXPECT_EQ(a.steps, r.steps);
    EXPECT_EQ(a.timeouts, r.timeouts);
    EXPECT_EQ(a.triggers, r.triggers);
    EXPECT_EQ(a.found, a.timeouts + a.triggers);
}

/** Its destructor leaves everything to the one of Activity. */
struct Careless : RTT::Activity {
    std::atomic<int> loops{0};
    Careless() : RTT::Activity(ORO_SCHED_OTHER, 0) {}
    void loop() override { ++loops; }
};

TEST(UserActivity, MayBeStoppedByOthersAndDestroyedByAnyThread) {
    together([](int t) {
        for (int i = 0; i != 50; ++i) {
            auto a = std::make_unique<Careless>();
            if (t % 2) {
                EXPECT_TRUE(a->start());
                // Refused while it is within its loop(), which is executed once more then.
                EXPECT_TRUE(eventually([&] { return a->loops != 0 && a->stop(); }));
            }
            if (i % 2)
                a.reset();
            else
                std::thread([&] { a.reset(); }).join();
        }
    });
}

#ifndef __SANITIZE_THREAD__  // the thread calls virtual functions until it is told to end, which is a race with the destructor
TEST(UserActivity, MayBeDestroyedWithoutStopWhenItIsIdle) {
    for (int i = 0; i != 100; ++i) {
        auto a = std::make_unique<Careless>();
        EXPECT_TRUE(a->start());
        EXPECT_TRUE(eventually([&] { return a->loops == 1; }));
        usleep(i % 10 * 100);
    }
}
#endif

TEST(UserActivity, IsThatOfAComponent) {
    struct Component : TaskContext {
        std::atomic<int> updates{0};
        Component() : TaskContext("component") {}
        ~Component() override { stop(); }
        void updateHook() override { ++updates; }
    } c;
    auto* const a = new ScheduleActivity(0.002, c.engine());
    ASSERT_TRUE(c.setActivity(a));
    EXPECT_EQ(c.getActivity<ScheduleActivity>(), a);
    ASSERT_TRUE(c.start());
    EXPECT_TRUE(eventually([&] { return c.updates >= 3; }));
    EXPECT_TRUE(c.stop());
    EXPECT_GE(a->timeouts, 3);
}

/** With a runner and loop() of the original's kind. */
TEST(UserRunnable, WithOnlyALoopIsExecutedByTriggers) {
    struct Loop : base::RunnableInterface {
        std::atomic<int> loops{0};
        bool initialize() override { return true; }
        void step() override {}
        void loop() override { ++loops; }
        bool breakLoop() override { return true; }
        void finalize() override {}
    } r;
    Activity a(os::LowestPriority, 0.0, &r, "loop");
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return r.loops == 1; }));
    EXPECT_TRUE(a.trigger());
    EXPECT_TRUE(eventually([&] { return r.loops == 2; }));
    EXPECT_TRUE(a.stop());
}

struct Sampler : extras::PeriodicActivity {
    std::atomic<int> samples{0}, works{0}, begun{0}, ended{0};
    Sampler() : extras::PeriodicActivity(ORO_SCHED_OTHER, 0, 0.002) {}
    ~Sampler() override { stop(); }
    bool initialize() override { return ++begun, true; }
    void step() override { ++samples; }
    void work(base::RunnableInterface::WorkReason) override { ++works; }
    void finalize() override { ++ended; }
};

TEST(UserPeriodicActivity, IsStartedAndStoppedBySeveralThreads) {
    Sampler one, two;
    together([&](int t) {
        Sampler& mine = t % 2 ? one : two;
        for (int i = 0; i != 100; ++i) {
            mine.start();
            mine.stop();
        }
    });
    one.stop();
    two.stop();
    EXPECT_EQ(one.begun, one.ended);
    EXPECT_EQ(two.begun, two.ended);
    ASSERT_TRUE(one.start());
    EXPECT_TRUE(eventually([&] { return one.samples >= 2 && one.works >= 1; }));
}

/** Adds something before each execution by its master. */
struct Coupled : extras::SlaveActivity {
    std::atomic<int> executions{0};
    Coupled(base::ActivityInterface* master, base::RunnableInterface* r) : extras::SlaveActivity(master, r) {}
    bool execute() override { return ++executions, extras::SlaveActivity::execute(); }
};

TEST(UserSlaveActivity, IsExecutedByItsMastersRunner) {
    CountingRunner masterRunner, r;
    Activity master(ORO_SCHED_OTHER, 0, 0.002, &masterRunner);
    auto slave = std::make_unique<Coupled>(&master, &r);
    masterRunner.onStep = [&] { slave->execute(); };
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(slave->start());
    EXPECT_TRUE(eventually([&] { return r.steps >= 3; }));
    EXPECT_TRUE(eventually([&] { return master.stop(); }));
    EXPECT_GE(slave->executions, r.steps);
    std::thread([&] { slave.reset(); }).join();
    EXPECT_EQ(r.finalized, 1);
}

struct LineReader : extras::FileDescriptorActivity {
    Pipe& pipe;
    std::atomic<int> bytes{0}, timeouts{0}, steps{0};
    explicit LineReader(Pipe& p) : extras::FileDescriptorActivity(ORO_SCHED_OTHER, 0), pipe(p) {}
    ~LineReader() override { stop(); }
    bool initialize() override { return watch(pipe.read), extras::FileDescriptorActivity::initialize(); }
    void step() override { ++steps; }
    void work(base::RunnableInterface::WorkReason reason) override {
        if (reason == base::RunnableInterface::TimeOut) ++timeouts;
        if (isUpdated(pipe.read))
            while (pipe.take()) ++bytes;
    }
    void finalize() override { clearAllWatches(); }
};

TEST(UserFileDescriptorActivity, ReadsWhatSeveralThreadsWrite) {
    Pipe pipe;
    LineReader reader(pipe);
    ASSERT_TRUE(reader.start());
    together([&](int) {
        for (int i = 0; i != 100; ++i) {
            EXPECT_TRUE(pipe.put());
            reader.trigger();
            if (i % 10 == 0) reader.timeout();
        }
    });
    EXPECT_TRUE(eventually([&] { return reader.bytes == kThreads * 100; }));
    EXPECT_TRUE(reader.timeout());
    EXPECT_TRUE(eventually([&] { return reader.timeouts >= 1; }));
    EXPECT_TRUE(reader.stop());
    EXPECT_FALSE(reader.isWatched(pipe.read));
    ASSERT_TRUE(reader.start());  // destroyed while it waits
}

}  // namespace
