// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Queues and pools of user code that hands pointers from thread to thread.
#include <rtt/internal/AtomicMWMRQueue.hpp>
#include <rtt/internal/AtomicMWSRQueue.hpp>
#include <rtt/internal/AtomicQueue.hpp>
#include <rtt/internal/TsPool.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>
#include <thread>
#include <vector>

using namespace RTT::internal;

namespace {

TEST(AtomicQueue, FirstInFirstOutUntilFull) {
    for (unsigned int size : {1u, 3u, 4u}) {
        std::vector<int> values(size + 1);
        AtomicQueue<int*> queue(size);
        int* out = nullptr;
        for (int round = 0; round < 3; ++round) {
            EXPECT_TRUE(queue.isEmpty());
            EXPECT_FALSE(queue.dequeue(out));
            for (unsigned int i = 0; i < size; ++i) EXPECT_TRUE(queue.enqueue(&values[i]));
            EXPECT_TRUE(queue.isFull());
            EXPECT_EQ(size, queue.size());
            EXPECT_FALSE(queue.enqueue(&values[size]));
            for (unsigned int i = 0; i < size; ++i) {
                EXPECT_TRUE(queue.dequeue(out));
                EXPECT_EQ(&values[i], out);
            }
        }
        EXPECT_EQ(size, queue.capacity());
    }
}

TEST(AtomicQueue, TakesNoNullAndIsCleared) {
    int value = 0;
    AtomicQueue<int*> queue(3);
    EXPECT_FALSE(queue.enqueue(nullptr));
    EXPECT_TRUE(queue.enqueue(&value));
    EXPECT_TRUE(queue.enqueue(&value));
    queue.clear();
    EXPECT_TRUE(queue.isEmpty());
    EXPECT_TRUE(queue.enqueue(&value));
}

TEST(AtomicQueue, FrontOfTheSingleReader) {
    int first = 1, second = 2;
    AtomicMWSRQueue<int*> queue(2);
    EXPECT_EQ(nullptr, queue.front());
    queue.enqueue(&first);
    queue.enqueue(&second);
    EXPECT_EQ(&first, queue.front());
    int* out = nullptr;
    EXPECT_TRUE(queue.dequeue(out));
    EXPECT_EQ(&second, queue.front());
}

TEST(AtomicQueue, EveryValueIsTakenOnceByOneOfManyThreads) {
    const unsigned int kEach = 5000;
    AtomicMWMRQueue<unsigned int> queue(7);
    std::vector<std::atomic<int>> taken(2 * kEach + 1);
    for (auto& count : taken) count = 0;
    std::atomic<unsigned int> left{2 * kEach};
    std::vector<std::thread> threads;
    for (unsigned int writer = 0; writer < 2; ++writer)
        threads.emplace_back([&, writer] {
            for (unsigned int i = 1; i <= kEach; ++i)
                while (!queue.enqueue(writer * kEach + i)) std::this_thread::yield();
        });
    for (int reader = 0; reader < 2; ++reader)
        threads.emplace_back([&] {
            unsigned int value = 0, last[2] = {0, 0};
            while (left.load() > 0) {
                if (!queue.dequeue(value)) {
                    std::this_thread::yield();
                    continue;
                }
                --left;
                ++taken[value];
                unsigned int& before = last[(value - 1) / kEach];
                EXPECT_LT(before, value);  // of one writer, in order
                before = value;
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (unsigned int value = 1; value <= 2 * kEach; ++value) ASSERT_EQ(1, taken[value].load()) << value;
    EXPECT_TRUE(queue.isEmpty());
}

TEST(TsPool, GivesEachObjectOnceAndTakesItBack) {
    TsPool<std::string> pool(3, "sample");
    EXPECT_EQ(3u, pool.capacity());
    EXPECT_EQ(3u, pool.size());
    std::set<std::string*> seen;
    for (int i = 0; i < 3; ++i) {
        std::string* object = pool.allocate();
        ASSERT_NE(nullptr, object);
        EXPECT_EQ("sample", *object);
        seen.insert(object);
    }
    EXPECT_EQ(3u, seen.size());
    EXPECT_EQ(nullptr, pool.allocate());
    EXPECT_EQ(0u, pool.size());
    **seen.begin() = "changed";
    EXPECT_TRUE(pool.deallocate(*seen.begin()));
    EXPECT_EQ(1u, pool.size());
    EXPECT_EQ(*seen.begin(), pool.allocate());
    pool.data_sample("new");
    EXPECT_EQ(3u, pool.size());
    EXPECT_EQ("new", *pool.allocate());
}

TEST(TsPool, RefusesWhatIsNotItsOwn) {
    TsPool<int> pool(2), other(1);
    EXPECT_FALSE(pool.deallocate(nullptr));
    EXPECT_FALSE(pool.deallocate(other.allocate()));
    EXPECT_EQ(2u, pool.size());
    TsPool<int> none(0);
    EXPECT_EQ(nullptr, none.allocate());
}

TEST(TsPool, NoObjectIsHeldByTwoThreads) {
    struct Object {
        std::atomic<int> holders{0};
        Object() = default;
        Object& operator=(const Object&) { return *this; }
        Object(const Object&) {}
    };
    TsPool<Object> pool(3);
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int round = 0; round < 5000; ++round) {
                Object* object = pool.allocate();
                if (!object) {
                    std::this_thread::yield();
                    continue;
                }
                EXPECT_EQ(0, object->holders.fetch_add(1));
                object->holders.fetch_sub(1);
                EXPECT_TRUE(pool.deallocate(object));
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(3u, pool.size());
}

}  // namespace
