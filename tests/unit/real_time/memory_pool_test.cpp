// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The allocator of real-time memory by itself. After every change its blocks and lists are checked.
#include <rtt/os/memory_pool.hpp>

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <vector>

using RTT::os::detail::MemoryPool;
using RTT::os::detail::SizeClass;

namespace {

constexpr std::size_t kHeader = 16;

class Pool : public testing::Test {
protected:
    static constexpr std::size_t kSize = 64 * 1024;
    std::vector<char> memory = std::vector<char>(kSize);
    struct Destroy {
        void operator()(MemoryPool* p) const { p->~MemoryPool(); }
    };
    std::unique_ptr<MemoryPool, Destroy> pool{MemoryPool::create(memory.data(), memory.size())};

    std::size_t largest() const { return pool->usage().total - pool->usage().overhead - kHeader; }
    void TearDown() override {
        if (pool) {
            EXPECT_EQ(pool->findFault(), "");
        }
    }
};

struct Held {
    unsigned char* block;
    std::size_t size;
    unsigned char mark;
    bool intact() const {
        return std::all_of(block, block + size, [this](unsigned char c) { return c == mark; });
    }
};

}  // namespace

TEST(SizeClass, EveryBlockOfTheListThatIsSearchedIsLargeEnough) {
    std::mt19937_64 random(1);
    for (std::size_t i = 1; i < 20000; ++i) {
        const std::size_t size = (i < 10000 ? i : random() % (SizeClass::kLargest / 16)) * 16;
        const SizeClass searched = SizeClass::atLeast(size);
        ASSERT_LT(searched.power, SizeClass::kPowers);
        ASSERT_LT(searched.part, SizeClass::kParts);
        // Blocks that are too small are in lists before it.
        const SizeClass smaller = SizeClass::of(size - 16);
        ASSERT_TRUE(smaller.power < searched.power || (smaller.power == searched.power && smaller.part < searched.part))
            << size;
        // A block one thirty-second larger will do.
        const SizeClass larger = SizeClass::of(std::max(size + size / 32 + 16, size));
        ASSERT_TRUE(searched.power < larger.power || (searched.power == larger.power && searched.part <= larger.part))
            << size;
    }
}

TEST_F(Pool, IsNotMadeOfTooLittleMemory) {
    EXPECT_EQ(MemoryPool::create(nullptr, kSize), nullptr);
    EXPECT_EQ(MemoryPool::create(memory.data(), 0), nullptr);
    EXPECT_EQ(MemoryPool::create(memory.data(), 1000), nullptr);
    const std::size_t least = pool->usage().overhead + kHeader + 16;
    pool.reset();
    EXPECT_EQ(MemoryPool::create(memory.data() + 3, least), nullptr) << "16 bytes are lost to alignment";
    pool.reset(MemoryPool::create(memory.data() + 3, least + 16));
    ASSERT_NE(pool, nullptr);
    EXPECT_NE(pool->allocate(16), nullptr);
    EXPECT_EQ(pool->allocate(1), nullptr);
}

TEST_F(Pool, BlocksAreAlignedAndApart) {
    std::vector<char*> blocks;
    for (std::size_t size : {0, 1, 15, 16, 17, 100, 511, 512, 513, 5000}) {
        auto* block = static_cast<char*>(pool->allocate(size));
        ASSERT_NE(block, nullptr);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % 16, 0u);
        for (char* other : blocks) EXPECT_GE(std::abs(block - other), 32);
        blocks.push_back(block);
        EXPECT_EQ(pool->findFault(), "");
    }
    for (char* block : blocks) pool->release(block);
}

TEST_F(Pool, TheWholePoolIsOneBlockAgainWhenAllIsReleased) {
    std::vector<void*> blocks;
    while (void* block = pool->allocate(100)) blocks.push_back(block);
    EXPECT_GT(blocks.size(), kSize / 160);
    EXPECT_EQ(pool->allocate(5000), nullptr);
    std::shuffle(blocks.begin(), blocks.end(), std::mt19937(2));
    for (void* block : blocks) {
        pool->release(block);
        ASSERT_EQ(pool->findFault(), "");
    }
    EXPECT_EQ(pool->usage().used, pool->usage().overhead);
    // A thirty-second less: the list that is searched holds larger blocks only.
    void* all = pool->allocate(largest() - largest() / 32);
    EXPECT_NE(all, nullptr);
    pool->release(all);
}

TEST_F(Pool, CountsWhatIsInUse) {
    const MemoryPool::Usage empty = pool->usage();
    EXPECT_EQ(empty.used, empty.overhead);
    EXPECT_LE(empty.total, kSize);
    EXPECT_GT(empty.total, kSize - 32);
    void* block = pool->allocate(1000);
    EXPECT_EQ(pool->usage().used, empty.used + 1008 + kHeader);
    pool->release(block);
    EXPECT_EQ(pool->usage().used, empty.used);
    EXPECT_EQ(pool->usage().maxUsed, empty.used + 1008 + kHeader);
    pool->release(nullptr);
}

TEST_F(Pool, TooMuchIsRefused) {
    EXPECT_EQ(pool->allocate(kSize), nullptr);
    EXPECT_EQ(pool->allocate(SIZE_MAX), nullptr);
    EXPECT_EQ(pool->allocate(SIZE_MAX - 15), nullptr);
    void* block = pool->allocate(8);
    EXPECT_EQ(pool->resize(block, SIZE_MAX), nullptr);
    EXPECT_EQ(pool->resize(block, kSize), nullptr);
    pool->release(block);
}

TEST_F(Pool, ResizingStaysInPlaceWhereItCan) {
    auto* first = static_cast<char*>(pool->allocate(100));
    std::memset(first, 1, 100);
    EXPECT_EQ(pool->resize(first, 3000), first);
    EXPECT_EQ(pool->resize(first, 50), first);
    auto* behind = static_cast<char*>(pool->allocate(50));
    EXPECT_EQ(pool->resize(first, 40), first);
    EXPECT_EQ(pool->findFault(), "");
    auto* moved = static_cast<char*>(pool->resize(first, 2000));
    ASSERT_NE(moved, nullptr);
    EXPECT_NE(moved, first);
    EXPECT_EQ(std::count(moved, moved + 40, 1), 40);
    pool->release(behind);
    pool->release(moved);
    EXPECT_EQ(pool->usage().used, pool->usage().overhead);
}

TEST_F(Pool, AnAreaMoreIsUsedToo) {
    EXPECT_EQ(pool->allocate(100000), nullptr);
    std::vector<char> more(200000);
    EXPECT_EQ(pool->addArea(more.data(), 40), 0u);
    EXPECT_EQ(pool->addArea(nullptr, 4000), 0u);
    const std::size_t usable = pool->addArea(more.data() + 1, more.size() - 1);
    EXPECT_GT(usable, 199900u);
    auto* block = static_cast<char*>(pool->allocate(100000));
    EXPECT_TRUE(block >= more.data() && block < more.data() + more.size());
    pool->release(block);
    EXPECT_EQ(pool->findFault(), "");
    pool.reset();  // before the area goes
}

TEST_F(Pool, KeepsItsInvariantsAndEveryByteInRandomUse) {
    std::mt19937 random(3);
    std::vector<Held> held;
    for (int i = 0; i < 20000; ++i) {
        const std::size_t size = random() % (random() % 8 == 0 ? 4000 : 200);
        const auto mark = static_cast<unsigned char>(random());
        const std::size_t at = held.empty() ? 0 : random() % held.size();
        const unsigned choice = random() % 5;
        if (choice < 2 || held.empty()) {
            if (auto* block = static_cast<unsigned char*>(pool->allocate(size))) {
                std::memset(block, mark, size);
                held.push_back({block, size, mark});
            }
        } else if (choice < 4) {
            ASSERT_TRUE(held[at].intact());
            pool->release(held[at].block);
            held[at] = held.back();
            held.pop_back();
        } else if (auto* block = static_cast<unsigned char*>(pool->resize(held[at].block, size))) {
            held[at].block = block;
            held[at].size = std::min(size, held[at].size);
            ASSERT_TRUE(held[at].intact());
            std::memset(block, held[at].mark, held[at].size = size);
        }
        ASSERT_EQ(pool->findFault(), "") << "after step " << i;
    }
    for (const Held& h : held) pool->release(h.block);
    EXPECT_EQ(pool->usage().used, pool->usage().overhead);
}

TEST_F(Pool, TheCheckFindsAnOverwrittenHeader) {
    auto* first = static_cast<unsigned char*>(pool->allocate(32));
    auto* second = static_cast<unsigned char*>(pool->allocate(32));
    const unsigned char good = second[-8];
    second[-8] = good + 16;  // its size
    EXPECT_NE(pool->findFault(), "");
    second[-8] = good | 1;  // used, but said to be free
    EXPECT_NE(pool->findFault(), "");
    second[-8] = good;
    second[-16] ^= 0x20;  // the block before it
    EXPECT_NE(pool->findFault(), "");
    second[-16] ^= 0x20;
    EXPECT_EQ(pool->findFault(), "");
    pool->release(first);
    std::memset(first + 8, 0xff, 8);  // written after release: its place in a list
    EXPECT_NE(pool->findFault(), "");
    std::memset(first + 8, 0, 8);
    EXPECT_EQ(pool->findFault(), "");
    pool->release(second);
}

using PoolDeathTest = Pool;

TEST_F(PoolDeathTest, ReleasingTwiceEndsTheProcess) {
    void* block = pool->allocate(10);
    void* other = pool->allocate(10);
    pool->release(block);
    EXPECT_DEATH(pool->release(block), "released twice");
    pool->release(other);
}

TEST_F(PoolDeathTest, WritingBeyondTheEndIsNoticedOnRelease) {
    auto* block = static_cast<char*>(pool->allocate(16));
    EXPECT_DEATH(
        {
            std::memset(block, 'x', 24);
            pool->release(block);
        },
        "beyond its end");
    pool->release(block);
}
