// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The trap catches what is planted, in the program and in the runtime's library, and nothing else.
#include <support/real_time_trap.hpp>

#include <rtt/os/Condition.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/Semaphore.hpp>
#include <rtt/os/futex.hpp>
#include <rtt/os/oro_malloc.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <thread>
#include <vector>

using namespace RTT;
using oroforge::test::expectRealTime;
using oroforge::test::RealTimeTrap;

namespace {

class Trap : public testing::Test {
protected:
    void SetUp() override { OROFORGE_NEEDS_REAL_TIME_TRAP(); }
};

/** What kinds f() was caught at. */
template <class F>
unsigned kindsOf(F f) {
    RealTimeTrap trap;
    f();
    trap.stop();
    trap.forgive();
    unsigned kinds = 0;
    for (unsigned kind : {RealTimeTrap::kAllocation, RealTimeTrap::kRelease, RealTimeTrap::kLock, RealTimeTrap::kWait})
        if (trap.caught(kind)) kinds |= kind;
    return kinds;
}

constexpr unsigned kBoth = RealTimeTrap::kAllocation | RealTimeTrap::kRelease;

// Not optimised away: the compiler may leave out a new that is deleted at once.
void* volatile leaked;

}  // namespace

TEST_F(Trap, CatchesAPlantedAllocation) {
    EXPECT_EQ(kindsOf([] { leaked = new int; }), RealTimeTrap::kAllocation);
    delete static_cast<int*>(leaked);
    EXPECT_EQ(kindsOf([] { leaked = std::malloc(100); }), RealTimeTrap::kAllocation);
    EXPECT_EQ(kindsOf([] { leaked = std::realloc(leaked, 100000); }), RealTimeTrap::kAllocation);
    std::free(leaked);
    EXPECT_EQ(kindsOf([] { leaked = std::calloc(10, 10); }), RealTimeTrap::kAllocation);
    std::free(leaked);
    EXPECT_EQ(kindsOf([] { leaked = std::aligned_alloc(64, 128); }), RealTimeTrap::kAllocation);
    std::free(leaked);
    struct alignas(128) Wide {
        char c[128];
    };
    EXPECT_EQ(kindsOf([] { leaked = new Wide; }), RealTimeTrap::kAllocation);
    delete static_cast<Wide*>(leaked);
}

TEST_F(Trap, CatchesAPlantedRelease) {
    leaked = new int;
    EXPECT_EQ(kindsOf([] { delete static_cast<int*>(leaked); }), RealTimeTrap::kRelease);
    leaked = std::malloc(100);
    EXPECT_EQ(kindsOf([] { std::free(leaked); }), RealTimeTrap::kRelease);
    EXPECT_EQ(kindsOf([] { std::free(nullptr); }), 0u);
}

TEST_F(Trap, CatchesWhatContainersAndExceptionsAllocate) {
    std::vector<double> v;
    EXPECT_EQ(kindsOf([&] { v.push_back(1); }), RealTimeTrap::kAllocation);
    EXPECT_EQ(kindsOf([&] { v.push_back(1); }), kBoth);
    std::string text(100, 'x');
    EXPECT_EQ(kindsOf([&] { v[0] = static_cast<double>(std::string(text).size()); }), kBoth);
    EXPECT_EQ(kindsOf([] {
                  try {
                      throw 1;
                  } catch (int) {
                  }
              }) & kBoth,
              kBoth);
}

TEST_F(Trap, CatchesAPlantedLockInTheProgram) {
    std::mutex mutex;
    EXPECT_EQ(kindsOf([&] { std::lock_guard<std::mutex> lock(mutex); }), RealTimeTrap::kLock);
    EXPECT_EQ(kindsOf([&] { std::unique_lock<std::mutex> lock(mutex, std::try_to_lock); }), RealTimeTrap::kLock);
    std::shared_mutex shared;
    EXPECT_EQ(kindsOf([&] { std::shared_lock<std::shared_mutex> lock(shared); }), RealTimeTrap::kLock);
    EXPECT_EQ(kindsOf([&] { std::unique_lock<std::shared_mutex> lock(shared); }), RealTimeTrap::kLock);
    std::timed_mutex timed;
    EXPECT_EQ(kindsOf([&] { (void)(timed.try_lock_for(std::chrono::milliseconds(1)) && (timed.unlock(), true)); }),
              RealTimeTrap::kLock);
}

TEST_F(Trap, CatchesAPlantedLockInALibrary) {
    os::Mutex mutex;
    os::MutexRecursive recursive;
    os::SharedMutex shared;
    EXPECT_EQ(kindsOf([&] { os::MutexLock lock(mutex); }), RealTimeTrap::kLock);
    EXPECT_EQ(kindsOf([&] { os::MutexTryLock lock(mutex); }), RealTimeTrap::kLock);
    EXPECT_EQ(kindsOf([&] { os::MutexTimedLock lock(recursive, 0.1); }), RealTimeTrap::kLock);
    EXPECT_EQ(kindsOf([&] { os::MutexLock lock(shared); }), RealTimeTrap::kLock);
    EXPECT_EQ(kindsOf([&] { os::SharedMutexLock lock(shared); }), RealTimeTrap::kLock);
}

TEST_F(Trap, CatchesAPlantedWait) {
    os::Mutex mutex;
    os::Condition condition;
    os::MutexLock lock(mutex);
    EXPECT_EQ(kindsOf([&] { condition.wait_until(mutex, 1); }), RealTimeTrap::kWait);
    std::mutex plain;
    std::condition_variable other;
    std::unique_lock<std::mutex> held(plain);
    EXPECT_EQ(kindsOf([&] { other.wait_for(held, std::chrono::milliseconds(1)); }), RealTimeTrap::kWait);
    os::Semaphore semaphore(1);
    EXPECT_EQ(kindsOf([&] { semaphore.wait(); }), RealTimeTrap::kWait);
    EXPECT_EQ(kindsOf([] { std::this_thread::sleep_for(std::chrono::microseconds(1)); }), RealTimeTrap::kWait);
    const std::atomic<std::uint32_t> word{0};
    EXPECT_EQ(kindsOf([&] { os::detail::futexWait(word, 0, 1); }), RealTimeTrap::kWait);
}

TEST_F(Trap, LetsThroughWhatIsAllowed) {
    std::atomic<std::uint32_t> word{0};
    os::Semaphore semaphore(0);
    std::vector<int> v;
    v.reserve(10);
    expectRealTime([&] {
        os::detail::futexWakeAll(word);
        semaphore.signal();
        EXPECT_TRUE(semaphore.trywait());
        v.push_back(1);
    });
    std::mutex mutex;
    expectRealTime([&] { std::lock_guard<std::mutex> lock(mutex); }, RealTimeTrap::kAllocation);
}

TEST_F(Trap, WatchesItsOwnThreadOnly) {
    std::atomic<int> stage{0};
    std::thread other([&] {
        while (stage != 1) std::this_thread::yield();
        std::make_unique<std::string>(100, 'x').reset();
        stage = 2;
    });
    expectRealTime([&] {
        stage = 1;
        while (stage != 2) std::this_thread::yield();
    });
    other.join();
}

TEST_F(Trap, WorksInEveryThread) {
    unsigned kinds = 0;
    std::thread([&] { kinds = kindsOf([] { leaked = new int; }); }).join();
    EXPECT_EQ(kinds, RealTimeTrap::kAllocation);
    delete static_cast<int*>(leaked);
}

TEST_F(Trap, FailsTheTestAndShowsWhereItHappened) {
    EXPECT_NONFATAL_FAILURE(expectRealTime([] { leaked = oro_rt_malloc(10); }), "MemoryPool::allocate");
    oro_rt_free(leaked);
    EXPECT_NONFATAL_FAILURE(expectRealTime([] { leaked = new int; }), "malloc() called by");
    delete static_cast<int*>(leaked);
}
