// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Real-time memory as programs use it: C functions, allocator, rt_string, rt_list.
#include <rtt/os/log_hook.hpp>
#include <rtt/os/oro_malloc.h>
#include <rtt/os/startstop.h>
#include <rtt/os/tlsf/tlsf.h>
#include <rtt/rt_list.hpp>
#include <rtt/rt_string.hpp>

#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <vector>

using namespace RTT;

namespace {

// Allocates before main() and frees after it; nothing may have been destroyed by then.
const rt_string keptToTheEnd(1000, 'x');

template <class T>
using RtVector = std::vector<T, os::rt_allocator<T>>;

/** A pool of the test's own, which memory is taken from while it lives. */
struct OwnPool {
    explicit OwnPool(std::size_t size) : memory(size), free(init_memory_pool(size, memory.data())) {}
    ~OwnPool() { destroy_memory_pool(memory.data()); }
    void* at() { return memory.data(); }
    std::vector<char> memory;
    const std::size_t free;
};

}  // namespace

TEST(RealTimeMemory, IsThereBeforeTheRuntimeStarts) {
    EXPECT_EQ(get_pool_size_mp(), 524288u);
    EXPECT_GE(get_used_size_mp(), get_overhead_size_mp() + 1000);
    EXPECT_EQ(keptToTheEnd.size(), 1000u);
}

TEST(RealTimeMemory, StartingTheRuntimeKeepsThePoolThatWasGiven) {
    OwnPool pool(100000);
    __os_init(0, nullptr);
    const std::size_t before = get_used_size(pool.at());
    void* block = oro_rt_malloc(500);
    EXPECT_GT(get_used_size(pool.at()), before);
    oro_rt_free(block);
    EXPECT_EQ(get_used_size(pool.at()), before);
    __os_exit();
    EXPECT_EQ(get_used_size(pool.at()), before);
}

TEST(RealTimeMemory, CallocFillsWithZeros) {
    auto* dirty = static_cast<char*>(oro_rt_malloc(400));
    std::memset(dirty, 'x', 400);
    oro_rt_free(dirty);
    auto* clean = static_cast<char*>(oro_rt_calloc(100, 4));
    ASSERT_NE(clean, nullptr);
    for (int i = 0; i < 400; ++i) ASSERT_EQ(clean[i], 0);
    oro_rt_free(clean);
    EXPECT_EQ(oro_rt_calloc(SIZE_MAX / 2, 4), nullptr) << "the product does not fit";
}

TEST(RealTimeMemory, ReallocBehavesLikeTheOneOfTheHeap) {
    auto* text = static_cast<char*>(oro_rt_realloc(nullptr, 6));
    std::strcpy(text, "hello");
    text = static_cast<char*>(oro_rt_realloc(text, 5000));
    EXPECT_STREQ(text, "hello");
    EXPECT_EQ(oro_rt_realloc(text, 1 << 30), nullptr);
    EXPECT_STREQ(text, "hello");
    const std::size_t used = get_used_size_mp();
    EXPECT_EQ(oro_rt_realloc(text, 0), nullptr);
    EXPECT_LT(get_used_size_mp(), used);
}

TEST(RealTimeMemory, FullPoolGivesNullAndTheAllocatorThrows) {
    OwnPool pool(20000);
    EXPECT_EQ(oro_rt_malloc(20000), nullptr);
    EXPECT_NE(oro_rt_malloc(1000), nullptr);
    EXPECT_THROW(rt_string(20000, 'x'), std::bad_alloc);
    RtVector<double> v;
    EXPECT_THROW(v.resize(10000), std::bad_alloc);
    EXPECT_THROW(os::rt_allocator<double>().allocate(SIZE_MAX / 8), std::bad_alloc);
    v.resize(100);
}

TEST(RealTimeMemory, ThePoolMadeLastIsUsedAndBlocksStayWithTheirOwn) {
    rt_string first(100, 'a');
    {
        OwnPool a(30000);
        rt_string second(100, 'b');
        {
            OwnPool b(30000);
            EXPECT_EQ(get_used_size(b.at()), get_overhead_size(b.at()));
            rt_string third(100, 'c');
            EXPECT_GT(get_used_size(b.at()), get_overhead_size(b.at()));
            second.clear();
            second.shrink_to_fit();
            EXPECT_EQ(get_used_size(a.at()), get_overhead_size(a.at()));
            EXPECT_GT(init_memory_pool(a.memory.size(), a.at()), 0u) << "again: selects it";
            EXPECT_EQ(get_pool_size_mp(), get_pool_size(a.at()));
        }
        first.assign(200, 'd');
        EXPECT_GT(get_used_size(a.at()), get_overhead_size(a.at()));
    }
    EXPECT_EQ(get_pool_size_mp(), 524288u);
    first.assign(1000, 'e');  // its memory went with the pool; that it is freed now does no harm
}

TEST(RealTimeMemory, PoolsMayBeUsedByName) {
    std::vector<char> memory(40000), area(40000);
    const std::size_t usable = init_memory_pool(memory.size(), memory.data());
    EXPECT_GT(usable, 30000u);
    EXPECT_EQ(get_pool_size(memory.data()) - get_overhead_size(memory.data()), usable + 16);
    EXPECT_EQ(get_max_size(memory.data()), get_overhead_size(memory.data()));
    void* block = malloc_ex(100, memory.data());
    block = realloc_ex(block, 200, memory.data());
    free_ex(block, memory.data());
    EXPECT_GT(get_max_size(memory.data()), get_used_size(memory.data()));
    EXPECT_EQ(calloc_ex(1, 35000, memory.data()), nullptr);
    EXPECT_GT(add_new_area(area.data(), area.size(), memory.data()), 35000u);
    block = calloc_ex(1, 35000, memory.data());
    EXPECT_NE(block, nullptr);
    tlsf_free(block);
    destroy_memory_pool(memory.data());
    EXPECT_EQ(malloc_ex(10, memory.data()), nullptr);
    EXPECT_EQ(get_pool_size(memory.data()), 0u);
    EXPECT_EQ(init_memory_pool(100, memory.data()), 0u) << "too small";
    EXPECT_EQ(init_memory_pool(1000, nullptr), 0u);
    EXPECT_EQ(add_new_area(area.data(), area.size(), memory.data()), 0u) << "no pool";
}

TEST(RealTimeMemory, ThePoolMayBeMadeAndDestroyedForEver) {
    std::vector<char> memory(20000);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_GT(init_memory_pool(memory.size(), memory.data()), 0u) << i;
        destroy_memory_pool(memory.data());
    }
}

TEST(RealTimeMemoryDeathTest, FreeingWhatIsNotFromAPoolEndsTheProcess) {
    int here = 0;
    EXPECT_DEATH(oro_rt_free(&here), "was not allocated here");
}

TEST(RtAllocator, ServesContainers) {
    const std::size_t before = get_used_size_mp();
    {
        RtVector<int> v{1, 2, 3};
        v.insert(v.end(), 1000, 4);
        rt_list<rt_string> list;
        list.push_back(rt_string("a string that is too long to need no memory"));
        list.emplace_front("b");
        std::map<int, int, std::less<int>, os::rt_allocator<std::pair<const int, int>>> m;
        m[3] = 4;
        EXPECT_GT(get_used_size_mp(), before + 4000);
        EXPECT_EQ(list.back().size() + list.front().size(), 44u);
        rt_list<rt_string> moved(std::move(list));
        EXPECT_EQ(moved.size(), 2u);
    }
    EXPECT_EQ(get_used_size_mp(), before);
}

TEST(RtAllocator, KeepsTheAlignmentOfItsType) {
    struct alignas(64) Wide {
        double d[8];
    };
    const std::size_t before = get_used_size_mp();
    {
        RtVector<Wide> v;
        for (int i = 0; i < 20; ++i) {
            v.emplace_back();
            ASSERT_EQ(reinterpret_cast<std::uintptr_t>(v.data()) % 64, 0u);
        }
    }
    EXPECT_EQ(get_used_size_mp(), before);
}

TEST(RtString, ConvertsAndPrints) {
    const rt_string text = makeRTString("a text of more than fifteen characters");
    EXPECT_EQ(makeString(text), "a text of more than fifteen characters");
    std::ostringstream out;
    out << text;
    EXPECT_EQ(out.str(), makeString(text));
    EXPECT_EQ(makeRTString(std::string("nul\0inside", 10)).size(), 10u);
}

TEST(RtAllocator, CanBeReboundFromVoid) {
    typedef os::rt_allocator<void>::rebind<double>::other Doubles;
    const os::rt_allocator<void> none;
    std::vector<double, Doubles> v((Doubles(none)));
    v.assign(100, 1.5);
    EXPECT_TRUE(v.get_allocator() == none);
    EXPECT_EQ(v[99], 1.5);
}

namespace {

int exhausted = 0;
std::string lastLine;
void countExhausted(int level, const char* module, std::string_view text) {
    EXPECT_EQ(level, 3);
    EXPECT_STREQ(module, "Memory");
    lastLine = text;
    ++exhausted;
}

}  // namespace

// Last: the log is not told any more.
TEST(RealTimeMemoryReport, ExhaustionIsReportedOnceUntilThereIsMemoryAgain) {
    OwnPool pool(20000);
    os::setLogHook(&countExhausted);
    void* most = oro_rt_malloc(9000);
    ASSERT_NE(most, nullptr);
    EXPECT_EQ(exhausted, 0);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(oro_rt_malloc(8000), nullptr);
    EXPECT_EQ(oro_rt_malloc(9000), nullptr);
    EXPECT_EQ(exhausted, 1);
    EXPECT_EQ(lastLine, "no real-time memory for 8000 bytes: " + std::to_string(get_used_size(pool.at())) + " of " +
                            std::to_string(get_pool_size(pool.at())) + " bytes are in use");
    EXPECT_EQ(oro_rt_malloc(6000), nullptr);
    EXPECT_EQ(exhausted, 2) << "less than ever before";
    oro_rt_free(oro_rt_malloc(10));
    EXPECT_EQ(oro_rt_malloc(6000), nullptr);
    EXPECT_EQ(exhausted, 2) << "a small block says nothing about large ones";
    oro_rt_free(most);
    oro_rt_free(oro_rt_malloc(6000));
    void* block = oro_rt_malloc(100);
    EXPECT_EQ(oro_rt_realloc(block, 20000), nullptr);
    EXPECT_EQ(exhausted, 3) << "there was memory in the meantime";
    oro_rt_free(block);
}
