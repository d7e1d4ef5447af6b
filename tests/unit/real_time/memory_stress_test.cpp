// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Threads that allocate, resize and free, and free what others allocated.
#include <rtt/os/memory_pool.hpp>
#include <rtt/os/oro_malloc.h>
#include <rtt/os/tlsf/tlsf.h>

#include <atomic>
#include <cstring>
#include <gtest/gtest.h>
#include <random>
#include <thread>
#include <vector>

using RTT::os::detail::MemoryPool;

namespace {

struct Block {
    std::size_t size;
    unsigned char mark;
    unsigned char bytes[1];
};

std::size_t roomFor(std::size_t size) { return offsetof(Block, bytes) + size; }

void fill(Block* block, std::size_t size, unsigned char mark) {
    block->size = size;
    block->mark = mark;
    std::memset(block->bytes, mark, size);
}

bool intact(const Block* block) {
    for (std::size_t i = 0; i != block->size; ++i)
        if (block->bytes[i] != block->mark) return false;
    return true;
}

/** Swaps blocks through shared slots, so most are freed by a thread that did not allocate them. */
template <class Allocate, class Resize, class Release>
void churn(unsigned seed, int steps, std::vector<std::atomic<Block*>>& slots, std::atomic<int>& torn, Allocate allocate,
           Resize resize, Release release) {
    std::mt19937 random(seed);
    for (int i = 0; i < steps; ++i) {
        const std::size_t size = random() % 300;
        const auto mark = static_cast<unsigned char>(random());
        auto* block = static_cast<Block*>(allocate(roomFor(size)));
        if (block) fill(block, size, mark);
        block = slots[random() % slots.size()].exchange(block, std::memory_order_acq_rel);
        if (!block) continue;
        if (!intact(block)) ++torn;
        if (random() % 4 == 0) {
            const std::size_t kept = std::min<std::size_t>(block->size, 100);
            if (auto* other = static_cast<Block*>(resize(block, roomFor(100)))) {
                other->size = kept;
                if (!intact(other)) ++torn;
                block = other;
            }
        }
        release(block);
    }
}

}  // namespace

TEST(MemoryStress, ManyThreadsOnOnePoolLoseNothing) {
    std::vector<char> memory(20000);  // small enough to run out now and then
    MemoryPool* pool = MemoryPool::create(memory.data(), memory.size());
    ASSERT_NE(pool, nullptr);
    std::vector<std::atomic<Block*>> slots(64);
    std::atomic<int> torn{0};
    std::atomic<bool> done{false};
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            churn(
                t, 40000, slots, torn, [&](std::size_t n) { return pool->allocate(n); },
                [&](void* p, std::size_t n) { return pool->resize(p, n); }, [&](void* p) { pool->release(p); });
        });
    std::string fault;
    std::thread checker([&] {
        while (!done && fault.empty()) fault = pool->findFault();
    });
    for (auto& thread : threads) thread.join();
    done = true;
    checker.join();
    EXPECT_EQ(fault, "");
    EXPECT_EQ(torn, 0);
    for (auto& slot : slots) pool->release(slot.load());
    EXPECT_EQ(pool->findFault(), "");
    EXPECT_EQ(pool->usage().used, pool->usage().overhead);
    pool->~MemoryPool();
}

TEST(MemoryStress, PoolsMayComeWhileThreadsAllocate) {
    std::vector<std::vector<char>> memories(4, std::vector<char>(30000));
    std::vector<std::atomic<Block*>> slots(32);
    std::atomic<int> torn{0};
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < 3; ++t)
        threads.emplace_back([&, t] { churn(t, 25000, slots, torn, &oro_rt_malloc, &oro_rt_realloc, &oro_rt_free); });
    std::vector<char> area(10000);
    for (auto& memory : memories) {
        EXPECT_GT(init_memory_pool(memory.size(), memory.data()), 0u);
        std::this_thread::yield();
    }
    EXPECT_GT(add_new_area(area.data(), area.size(), memories[0].data()), 0u);
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(torn, 0);
    for (auto& slot : slots) oro_rt_free(slot.load());
    for (auto& memory : memories) {
        EXPECT_EQ(get_used_size(memory.data()), get_overhead_size(memory.data()));
        destroy_memory_pool(memory.data());
    }
}
