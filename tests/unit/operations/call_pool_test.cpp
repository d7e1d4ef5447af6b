// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "probe.hpp"

#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/calls/call_pool.hpp>

#include <cstring>
#include <memory>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::makeManual;
using oroforge::test::Probe;

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

TEST(CallPool, MoreCallsThanItHasAreExecutedAllTheSame) {
    constexpr std::size_t kCalls = CallPool::kSmall + CallPool::kLarge + 60;
    std::vector<std::unique_ptr<Probe>> servers;
    std::vector<SendHandle<int(int)>> handles;
    while (handles.size() != kCalls) {
        if (handles.size() % 100 == 0) {
            servers.push_back(std::make_unique<Probe>());
            makeManual(*servers.back());
            servers.back()->addOperation(
                "twice", [](int n) { return 2 * n; }, OwnThread);
        }
        OperationCaller<int(int)> twice(servers.back()->getOperation("twice"), GlobalEngine::Instance());
        handles.push_back(twice.send(static_cast<int>(handles.size())));
        ASSERT_TRUE(handles.back().ready());
    }
    EXPECT_FALSE(CallPool::owns(handles.back().call().get()));
    for (const auto& server : servers) ASSERT_TRUE(server->update());
    for (std::size_t i = 0; i != kCalls; ++i) {
        int result = -1;
        EXPECT_EQ(handles[i].collect(result), SendSuccess);
        EXPECT_EQ(result, 2 * static_cast<int>(i));
    }
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
