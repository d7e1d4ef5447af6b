// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"
#include "together.hpp"

#include <rtt/Activity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/os/detail/wake_word.hpp>

#include <thread>

using namespace RTT;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::kThreads;
using oroforge::test::together;

namespace {

/** Orders like a mailbox: plain numbers written before trigger() must be seen by the pass that it causes. */
struct Mailbox : CountingRunner {
    std::atomic<int> posted[kThreads] = {};
    std::atomic<int> seen[kThreads] = {};

    Mailbox() {
        onWork = [this](auto) {
            for (int t = 0; t < kThreads; ++t)
                seen[t].store(posted[t].load(std::memory_order_relaxed), std::memory_order_relaxed);
        };
    }
    bool hasWork() override {
        for (int t = 0; t < kThreads; ++t)
            if (seen[t].load(std::memory_order_relaxed) != posted[t].load(std::memory_order_relaxed)) return true;
        return false;
    }
};

}  // namespace

TEST(WakeWord, ThreadOfOneReasonSeesWhatWasWrittenBefore) {
    os::detail::WakeWord word;
    int payload = 0;
    std::atomic<int> taken{0};
    std::thread owner([&] {
        for (int i = 1; i <= 20000; ++i) {
            EXPECT_EQ(word.wait(os::detail::kForever), 1u);
            EXPECT_EQ(payload, i);
            taken.store(i, std::memory_order_release);
        }
    });
    for (int i = 1; i <= 20000; ++i) {
        payload = i;
        word.post(1u);
        while (taken.load(std::memory_order_acquire) != i) std::this_thread::yield();
    }
    owner.join();
}

TEST(WakeWord, TimeEndsTheWait) {
    os::detail::WakeWord word;
    const nsecs deadline = rtos_get_time_ns() + 5000000;
    EXPECT_EQ(word.wait(deadline), 0u);
    EXPECT_GE(rtos_get_time_ns(), deadline);
    word.post(4u);
    word.post(8u);
    EXPECT_EQ(word.wait(0), 12u);
    EXPECT_EQ(word.wait(0), 0u);
}

TEST(ActivityStorm, NoTriggerIsLost) {
    Mailbox r;
    Activity a(&r);
    ASSERT_TRUE(a.start());
    // Every thread waits for its own post to be served: a single lost wake-up hangs it.
    std::atomic<int> lost{0};
    together([&](int t) {
        for (int i = 1; i <= 3000; ++i) {
            r.posted[t].store(i, std::memory_order_relaxed);
            a.trigger();
            if (i % 3 == 0 && !eventually([&] { return r.seen[t].load(std::memory_order_relaxed) == i; })) {
                ++lost;
                return;
            }
        }
    });
    EXPECT_EQ(lost, 0);
    EXPECT_TRUE(eventually([&] { return !r.hasWork(); }));
    EXPECT_TRUE(a.stop());
}

TEST(ActivityStorm, NoTriggerIsLostBesidePeriodsAndTimeouts) {
    Mailbox r;
    Activity a(ORO_SCHED_OTHER, 0, 0.0, &r);
    ASSERT_TRUE(a.start());
    std::atomic<int> lost{0};
    together([&](int t) {
        for (int i = 1; i <= 300; ++i) {
            if (t == 0) {
                a.setPeriod(i % 2 ? 0.0005 : 0.0);
                a.timeout();
            }
            r.posted[t].store(i, std::memory_order_relaxed);
            a.trigger();
            if (!eventually([&] { return r.seen[t].load(std::memory_order_relaxed) == i; })) {
                ++lost;
                return;
            }
        }
    });
    EXPECT_EQ(lost, 0);
    EXPECT_TRUE(eventually([&] { return a.stop(); }));
}

TEST(ActivityStorm, StartAndStopFromSeveralThreads) {
    for (const Seconds period : {0.0, 0.0002}) {
        CountingRunner r;
        int inSession = 0;  // not atomic: start, session and stop must be ordered
        r.onFinalize = [&] { inSession = 0; };
        r.onWork = [&](auto) { ++inSession; };
        Activity a(ORO_SCHED_OTHER, 0, period, &r);
        a.setStopTimeout(20.0);
        std::atomic<int> stops{0};
        together([&](int) {
            for (int i = 0; i < 300; ++i) {
                a.start();
                a.trigger();
                if (i % 4 == 0) std::this_thread::yield();
                stops += a.stop();
            }
        });
        a.stop();
        EXPECT_FALSE(a.isActive());
        EXPECT_EQ(r.initialized, r.finalized);
        EXPECT_GE(r.finalized, stops);
        EXPECT_GT(stops, 0);
        // It still works.
        const int triggers = r.triggers;
        EXPECT_TRUE(a.start());
        EXPECT_TRUE(eventually([&] { return r.triggers > triggers; }));
        EXPECT_TRUE(a.stop());
    }
}

TEST(ActivityStorm, CreateStartDestroy) {
    together([](int t) {
        for (int i = 0; i < 30; ++i) {
            CountingRunner r;
            Activity a(ORO_SCHED_OTHER, 0, t % 2 ? 0.001 : 0.0, &r);
            EXPECT_TRUE(a.start());
            a.trigger();
        }
    });
}

TEST(SequentialStorm, NoMessageIsForgottenAndCallersExclude) {
    struct Queue : CountingRunner {
        std::atomic<int> waiting{0};
        int served = 0;  // not atomic: one thread at a time executes
        void work(WorkReason) override {
            while (int n = waiting.exchange(0)) served += n;
        }
        bool hasWork() override { return waiting != 0; }
    } r;
    extras::SequentialActivity a(&r);
    ASSERT_TRUE(a.start());
    together([&](int) {
        for (int i = 0; i < 5000; ++i) {
            ++r.waiting;
            EXPECT_TRUE(a.trigger());
        }
    });
    EXPECT_TRUE(a.stop());
    EXPECT_EQ(r.waiting, 0);
    EXPECT_EQ(r.served, kThreads * 5000);
}

TEST(SequentialStorm, StopWaitsForTheExecutingThread) {
    CountingRunner r;
    std::atomic<bool> inside{false};
    std::atomic<int> steps{0}, early{0};
    int plain = 0;  // not atomic: ThreadSanitizer sees whether finalize() comes after the execution
    r.onStep = [&] {
        inside = true;
        ++plain;
        ++steps;
        inside = false;
    };
    r.onFinalize = [&] {
        if (inside) ++early;
        plain = 0;
    };
    extras::SequentialActivity a(&r);
    std::atomic<bool> done{false};
    together([&](int t) {
        if (t != 0) {
            while (!done) a.trigger();
            return;
        }
        for (int i = 0; i < 1000; ++i) {
            EXPECT_TRUE(a.start());
            EXPECT_TRUE(a.stop());
            if (inside) ++early;
        }
        // At least one execution has to meet the storm.
        EXPECT_TRUE(a.start());
        EXPECT_TRUE(eventually([&] { return steps != 0; }));
        EXPECT_TRUE(a.stop());
        done = true;
    });
    EXPECT_EQ(early, 0);
}
