// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/os/Atomic.hpp>
#include <rtt/os/CAS.hpp>
#include <rtt/os/Condition.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/Semaphore.hpp>

#include <thread>
#include <vector>

using namespace RTT;
using oroforge::test::eventually;

template <class M>
class AnyMutex : public testing::Test {
public:
    M mutex;
    bool inOtherThread(std::function<bool()> f) {
        bool result = false;
        std::thread([&] { result = f(); }).join();
        return result;
    }
};
using Mutexes = testing::Types<os::Mutex, os::MutexRecursive>;
TYPED_TEST_SUITE(AnyMutex, Mutexes);

TYPED_TEST(AnyMutex, ExcludesOtherThreads) {
    os::MutexInterface& m = this->mutex;
    m.lock();
    EXPECT_FALSE(this->inOtherThread([&] { return m.trylock(); }));
    EXPECT_FALSE(this->inOtherThread([&] { return m.timedlock(0.01); }));
    m.unlock();
    EXPECT_TRUE(this->inOtherThread([&] { return m.trylock() && (m.unlock(), true); }));
    EXPECT_TRUE(this->inOtherThread([&] { return m.timedlock(0.0) && (m.unlock(), true); }));
    EXPECT_TRUE(this->inOtherThread([&] { return m.timedlock(InfiniteSeconds) && (m.unlock(), true); }));
    EXPECT_FALSE(m.trylock_shared());
}

TYPED_TEST(AnyMutex, TimedLockWaits) {
    os::MutexLock held(this->mutex);
    const nsecs start = rtos_get_time_ns();
    EXPECT_FALSE(this->inOtherThread([&] { return os::MutexTimedLock(this->mutex, 0.05).isSuccessful(); }));
    EXPECT_GE(rtos_get_time_ns() - start, 50000000);
}

TYPED_TEST(AnyMutex, CountersDoNotLoseIncrements) {
    int count = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i < 2000; ++i) {
                os::MutexLock lock(this->mutex);
                ++count;
            }
        });
    for (auto& t : threads) t.join();
    EXPECT_EQ(count, 8000);
}

TEST(MutexRecursive, HolderMayLockAgain) {
    os::MutexRecursive m;
    os::MutexLock first(m);
    os::MutexTryLock second(m);
    EXPECT_TRUE(second.isSuccessful());
}

TEST(Mutex, HolderMayNotLockAgain) {
    os::Mutex m;
    os::MutexLock first(m);
    EXPECT_FALSE(os::MutexTryLock(m).isSuccessful());
}

TEST(SharedMutex, ReadersShareWritersExclude) {
    os::SharedMutex m;
    EXPECT_FALSE(m.trylock());
    EXPECT_FALSE(m.timedlock(0.0));
    int value = 0;
    std::atomic<bool> torn{false};
    std::vector<std::thread> threads;
    {
        os::SharedMutexLock one(m);
        std::thread([&] { os::SharedMutexLock two(m); }).join();  // would hang if not shared
    }
    for (int t = 0; t < 2; ++t) {
        threads.emplace_back([&] {
            for (int i = 0; i < 500; ++i) {
                os::MutexLock lock(m);
                ++value;
                ++value;
            }
        });
        threads.emplace_back([&] {
            for (int i = 0; i < 500; ++i) {
                os::SharedMutexLock lock(m);
                if (value % 2) torn = true;
            }
        });
    }
    for (auto& t : threads) t.join();
    EXPECT_EQ(value, 2000);
    EXPECT_FALSE(torn);
}

TEST(Condition, BroadcastWakesEveryWaiter) {
    os::Mutex m;
    os::Condition c;
    bool go = false;
    int woken = 0;
    std::vector<std::thread> waiters;
    for (int i = 0; i < 3; ++i)
        waiters.emplace_back([&] {
            os::MutexLock lock(m);
            auto gone = [&] { return go; };
            c.wait(m, gone);
            ++woken;
        });
    {
        os::MutexLock lock(m);
        go = true;
        c.broadcast();
    }
    for (auto& t : waiters) t.join();
    EXPECT_EQ(woken, 3);
}

TEST(Condition, WaitUntilEndsAtItsTime) {
    os::Mutex m;
    os::Condition c;
    os::MutexLock lock(m);
    const nsecs deadline = rtos_get_time_ns() + 20000000;
    while (c.wait_until(m, deadline)) {
    }
    EXPECT_GE(rtos_get_time_ns(), deadline);
    EXPECT_FALSE(c.wait_until(m, 1));  // long ago
}

TEST(Semaphore, CountsSignals) {
    os::Semaphore s(1);
    EXPECT_EQ(s.value(), 1);
    EXPECT_TRUE(s.trywait());
    EXPECT_FALSE(s.trywait());
    std::thread signaller([&] { s.signal(); });
    s.wait();
    signaller.join();
    EXPECT_EQ(s.value(), 0);
}

TEST(Atomic, TestsTellWhetherZeroWasReached) {
    os::AtomicInt a(2);
    EXPECT_FALSE(a.dec_and_test());
    EXPECT_TRUE(a.dec_and_test());
    a.set(-1);
    EXPECT_TRUE(a.inc_and_test());
    a.add(5);
    a.sub(2);
    EXPECT_TRUE(a.sub_and_test(3));
    a.inc();
    EXPECT_EQ(a.read(), 1);
    a.dec();
    EXPECT_EQ(a.read(), 0);
}

TEST(Cas, ReplacesOnlyWhatWasExpected) {
    int i = 1;
    EXPECT_FALSE(os::CAS(&i, 2, 3));
    EXPECT_EQ(i, 1);
    EXPECT_TRUE(os::CAS(&i, 1, 3));
    EXPECT_EQ(i, 3);
    int* volatile p = nullptr;
    EXPECT_TRUE(os::CAS(&p, static_cast<int*>(nullptr), &i));
    EXPECT_EQ(p, &i);
    struct alignas(4) Pair {
        short index, tag;
    } pair = {1, 2};
    EXPECT_TRUE(os::CAS(&pair, Pair{1, 2}, Pair{3, 4}));
    EXPECT_EQ(pair.index, 3);
}
