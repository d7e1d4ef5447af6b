// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/reclaimer.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

using RTT::internal::DeferredCalls;
using RTT::internal::Reclaimer;

namespace {
void countDown(void* counter) { --*static_cast<std::atomic<int>*>(counter); }
void countUp(void*& counter) { ++*static_cast<std::atomic<int>*>(counter); }
}  // namespace

TEST(Reclaimer, DestroysAtOnceWhenNobodyIsInside) {
    std::atomic<int> objects{1};
    Reclaimer::retire(&objects, countDown);
    EXPECT_EQ(objects, 1);
    Reclaimer::collect();
    EXPECT_EQ(objects, 0);
}

TEST(Reclaimer, KeepsWhatAThreadInsideMayUse) {
    std::atomic<int> objects{1};
    {
        const Reclaimer::Guard outer;
        {
            const Reclaimer::Guard inner;
            Reclaimer::retire(&objects, countDown);
        }
        Reclaimer::collect();
        EXPECT_EQ(objects, 1);
    }
    Reclaimer::collect();
    EXPECT_EQ(objects, 0);
}

TEST(Reclaimer, DestroysWhatWasRetiredBeforeAThreadCameIn) {
    std::atomic<int> objects{1};
    Reclaimer::retire(&objects, countDown);
    const Reclaimer::Guard guard;
    Reclaimer::collect();
    EXPECT_EQ(objects, 0);
}

TEST(Reclaimer, RunsDeferredCallsAfterTheOutermostGuard) {
    std::atomic<int> calls{0};
    {
        const Reclaimer::Guard outer;
        {
            const Reclaimer::Guard inner;
            EXPECT_TRUE(Reclaimer::deferred().add(nullptr, countUp, &calls));
        }
        EXPECT_EQ(calls, 0);
    }
    EXPECT_EQ(calls, 1);
}

TEST(Reclaimer, SynchronizeWaitsForThoseInside) {
    std::atomic<int> stage{0};
    std::thread inside([&] {
        const Reclaimer::Guard guard;
        stage = 1;
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        stage = 2;
    });
    while (stage == 0) std::this_thread::yield();
    Reclaimer::synchronize();
    EXPECT_EQ(stage, 2);
    inside.join();
}

TEST(Reclaimer, TwoThatSynchronizeInsideDoNotWaitForEachOther) {
    std::atomic<int> inside{0};
    auto both = [&] {
        const Reclaimer::Guard guard;
        ++inside;
        while (inside < 2) std::this_thread::yield();
        Reclaimer::synchronize();
    };
    std::thread a(both), b(both);
    a.join();
    b.join();
}

TEST(Reclaimer, NeverDestroysWhatReadersSee) {
    struct Object {
        std::atomic<int> alive{1};
        int payload = 42;
    };
    std::atomic<Object*> shared{new Object};
    std::atomic<bool> stop{false};
    std::atomic<int> dead{0};
    std::vector<std::thread> readers;
    for (int i = 0; i < 3; ++i)
        readers.emplace_back([&] {
            while (!stop) {
                const Reclaimer::Guard guard;
                Object* object = shared.load(std::memory_order_acquire);
                if (object->alive.load(std::memory_order_relaxed) != 1 || object->payload != 42) ++dead;
            }
        });
    for (int i = 0; i < 3000; ++i) {
        Object* old = shared.exchange(new Object, std::memory_order_acq_rel);
        Reclaimer::retire(old, [](void* o) {
            static_cast<Object*>(o)->alive = 0;
            delete static_cast<Object*>(o);
        });
        Reclaimer::collect();
    }
    stop = true;
    for (std::thread& t : readers) t.join();
    EXPECT_EQ(dead, 0);
    delete shared.load();
    Reclaimer::collect();
    EXPECT_EQ(Reclaimer::pending(), 0u);
}

namespace {

/** Notes what is called. */
struct Log {
    static void note(void*& argument) { calls.push_back(*static_cast<int*>(argument)); }
    static std::vector<int> calls;
};
std::vector<int> Log::calls;

}  // namespace

TEST(DeferredCalls, AreMadeInOrderWithoutThoseThatWereCancelled) {
    Log::calls.clear();
    DeferredCalls calls;
    DeferredCalls::Call places[4];
    int numbers[] = {0, 1, 2, 3, 4, 5, 6, 7};
    for (int i = 0; i != 8; ++i) EXPECT_TRUE(calls.add(i % 2 ? &places[i / 2] : nullptr, Log::note, &numbers[i]));
    for (const int i : {0, 3, 7}) EXPECT_EQ(calls.cancel(&numbers[i]), 1u);
    EXPECT_EQ(calls.cancel(&numbers[3]), 0u);
    EXPECT_TRUE(calls.add(&places[1], Log::note, &numbers[3]));
    calls.run();
    EXPECT_EQ(Log::calls, (std::vector<int>{1, 2, 4, 5, 6, 3}));
    EXPECT_TRUE(calls.empty());
}

TEST(DeferredCalls, SparePlacesAreFreeAgainWhenTheCallBegins) {
    Log::calls.clear();
    DeferredCalls calls;
    int number = 1;
    for (int round = 0; round != 3; ++round) {
        for (std::uint32_t i = 0; i != DeferredCalls::kSpare; ++i) EXPECT_TRUE(calls.add(nullptr, Log::note, &number));
        EXPECT_FALSE(calls.add(nullptr, Log::note, &number));
        if (round == 1) {
            EXPECT_EQ(calls.cancel(&number), DeferredCalls::kSpare);
        }
        calls.run();
    }
    EXPECT_EQ(Log::calls.size(), 2 * DeferredCalls::kSpare);
}
