// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Threads and timers as users write them.
#include "os_test.hpp"
#include "together.hpp"

#include <rtt/os/MutexLock.hpp>
#include <rtt/os/Semaphore.hpp>
#include <rtt/os/Thread.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/Timer.hpp>

#include <memory>
#include <thread>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::kThreads;
using oroforge::test::LogCapture;
using oroforge::test::together;

namespace {

/** Waits for a semaphore in its loop(), as dispatchers do. */
class Dispatcher : public RTT::os::Thread {
public:
    Dispatcher() : RTT::os::Thread(ORO_SCHED_OTHER, os::LowestPriority, 0.0, 0, "Dispatcher"), requests_(0) {}
    ~Dispatcher() override { stop(); }

    bool initialize() override { return quit_ = false, ++initialized, true; }
    void loop() override {
        while (!quit_) {
            requests_.wait();
            if (!quit_) ++served;
        }
    }
    bool breakLoop() override {
        quit_ = true;
        requests_.signal();
        return true;
    }
    void finalize() override { ++finalized; }
    void request() { requests_.signal(); }
    std::atomic<int> served{0}, initialized{0}, finalized{0};

private:
    os::Semaphore requests_;
    std::atomic<bool> quit_{false};
};

TEST(UserThread, ServesRequestsOfSeveralThreads) {
    Dispatcher d;
    ASSERT_TRUE(d.start());
    together([&](int) {
        for (int i = 0; i != 1000; ++i) d.request();
    });
    EXPECT_TRUE(eventually([&] { return d.served == kThreads * 1000; }));
}

TEST(UserThread, IsStartedAndStoppedBySeveralThreads) {
    Dispatcher d;
    d.setStopTimeout(20.0);
    std::atomic<int> stops{0};
    together([&](int) {
        for (int i = 0; i != 200; ++i) {
            d.start();
            d.request();
            stops += d.stop();
        }
    });
    stops += d.stop();
    EXPECT_EQ(d.initialized, d.finalized);
    EXPECT_EQ(d.finalized, stops);
}

TEST(UserThread, MayBeDestroyedByAnotherThread) {
    for (int i = 0; i != 50; ++i) {
        auto d = std::make_unique<Dispatcher>();
        ASSERT_TRUE(d->start());
        std::thread([&] { d.reset(); }).join();
    }
}

/** Periodic, and stopped by whoever owns it. */
struct Ticker : RTT::os::Thread {
    std::atomic<int> ticks{0};
    explicit Ticker(Seconds period) : RTT::os::Thread(ORO_SCHED_OTHER, 0, period, 0, "Ticker") {}
    void step() override { ++ticks; }
};

TEST(UserThread, PeriodicOneNeedsNoDestructorIfItIsStopped) {
    Ticker t(0.001);
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return t.ticks >= 5; }));
    EXPECT_TRUE(t.stop());
    const int ticks = t.ticks;
    usleep(5000);
    EXPECT_EQ(t.ticks, ticks);
    EXPECT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return t.ticks > ticks; }));
    EXPECT_TRUE(t.stop());
}

TEST(UserThread, WithAPeriodThatNeverEndsStepsOnce) {
    Ticker t(InfiniteSeconds);
    ASSERT_TRUE(t.start());
    EXPECT_TRUE(eventually([&] { return t.ticks >= 1; }));
    usleep(10000);
    EXPECT_EQ(t.ticks, 1);
    t.setStopTimeout(InfiniteSeconds);
    EXPECT_TRUE(t.stop());
    EXPECT_FALSE(t.stop());
}

TEST(UserThread, ThatIsDestroyedInItsLoopIsReported) {
    const LogCapture log;
    std::atomic<bool> inside{false}, leave{false}, gone{false};
    struct Busy : RTT::os::Thread {
        std::atomic<bool>&inside, &leave;
        Busy(std::atomic<bool>& i, std::atomic<bool>& l)
            : RTT::os::Thread(ORO_SCHED_OTHER, 0, 0.0, 0, "busy"), inside(i), leave(l) {}
        ~Busy() override { terminate(); }  // and no stop()
        void loop() override {
            inside = true;
            eventually([&] { return leave.load(); });
        }
    };
    auto busy = std::make_unique<Busy>(inside, leave);
    busy->setStopTimeout(0.02);
    ASSERT_TRUE(busy->start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    std::thread destroyer([&] {
        busy.reset();
        gone = true;
    });
    EXPECT_TRUE(eventually([&] { return log.count(3, "thread 'busy' is being destroyed while its loop()") == 1; }));
    EXPECT_FALSE(gone);
    leave = true;
    destroyer.join();
}

/** A component that is one as well: what times out is noted under a mutex. */
class Alarm : public RTT::os::Timer {
public:
    explicit Alarm(int timers) : RTT::os::Timer(timers, ORO_SCHED_OTHER, os::LowestPriority, "Alarm") {}
    void timeout(TimerId id) override {
        os::MutexLock lock(mutex_);
        ++counts_[id];
    }
    int count(TimerId id) {
        os::MutexLock lock(mutex_);
        return counts_[id];
    }

private:
    os::Mutex mutex_;
    int counts_[8] = {};
};

TEST(UserTimer, IsUsedBySeveralThreads) {
    Alarm alarm(kThreads);
    together([&](int t) {
        for (int i = 1; i <= 20; ++i) {
            EXPECT_TRUE(alarm.arm(t, 0.0));
            EXPECT_TRUE(eventually([&] { return alarm.count(t) == i; }));
        }
        EXPECT_TRUE(alarm.startTimer(t, 0.001));
        EXPECT_TRUE(eventually([&] { return alarm.count(t) >= 23; }));
        EXPECT_TRUE(alarm.killTimer(t));
        EXPECT_EQ(alarm.timeRemaining(t), 0.0);
    });
}

TEST(UserTimer, NeedsNoDestructorIfNothingIsArmed) {
    for (int i = 0; i != 100; ++i) {
        Alarm alarm(1);
        ASSERT_TRUE(alarm.arm(0, 0.0));
        ASSERT_TRUE(eventually([&] { return alarm.count(0) == 1; }));
    }
}

TEST(UserTimer, WaitersAreFreedThoughTheTimerIsThereAgain) {
    for (int i = 0; i != 20; ++i) {
        Alarm alarm(3);
        ASSERT_TRUE(alarm.arm(2, 1000.0));
        std::atomic<bool> waiting{false}, returned{false};
        std::thread waiter([&] {
            waiting = true;
            (void)alarm.waitFor(2);
            returned = true;
        });
        ASSERT_TRUE(eventually([&] { return waiting.load(); }));
        usleep(2000);
        alarm.setMaxTimers(1);
        alarm.setMaxTimers(3);
        EXPECT_TRUE(eventually([&] { return returned.load(); }));
        alarm.killTimer(2);
        if (!returned) {
            alarm.arm(2, 0.0);  // lets the waiter go
        }
        waiter.join();
    }
}

}  // namespace
