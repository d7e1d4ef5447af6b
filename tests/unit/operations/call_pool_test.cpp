// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/CallPool.hpp>

#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <vector>

using RTT::internal::CallPool;

namespace {

TEST(CallPool, GivesBlocksOfItsOwnUntilTheyAreUsedUpThenOfTheHeap) {
    std::vector<void*> blocks;
    while (CallPool::owns(blocks.emplace_back(CallPool::take(100)))) ASSERT_LT(blocks.size(), 10000u);
    EXPECT_EQ(blocks.size(), CallPool::kSmall + CallPool::kLarge + 1) << "the large ones serve small calls, too";
    for (void* block : blocks) CallPool::give(block);
    void* again = CallPool::take(100);
    EXPECT_TRUE(CallPool::owns(again));
    CallPool::give(again);
}

TEST(CallPool, LargeCallsComeFromTheHeap) {
    void* block = CallPool::take(5000);
    EXPECT_FALSE(CallPool::owns(block));
    std::memset(block, 1, 5000);
    CallPool::give(block);
}

TEST(CallPoolStress, NoBlockIsGivenTwice) {
    std::vector<std::thread> threads;
    for (int t = 0; t != 4; ++t)
        threads.emplace_back([t] {
            for (int i = 0; i != 20000; ++i) {
                auto* a = static_cast<int*>(CallPool::take(64));
                auto* b = static_cast<int*>(CallPool::take(i % 2 ? 64 : 600));
                *a = t;
                *b = ~t;
                EXPECT_EQ(*a, t);
                EXPECT_EQ(*b, ~t);
                CallPool::give(a);
                CallPool::give(b);
            }
        });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
