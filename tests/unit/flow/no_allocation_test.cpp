// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Writing and reading do not allocate once samples are sized.
#include <rtt/Port.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <vector>

namespace {
thread_local bool watching = false;
thread_local unsigned allocations = 0;

// Not inlined, nor is the other: the compiler would take what the replaced operators do for a mismatch.
[[gnu::noinline]] void* allocate(std::size_t size, std::size_t alignment) {
    if (watching) ++allocations;
    void* p = alignment > alignof(std::max_align_t)
                  ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                  : std::malloc(size ? size : 1);
    if (!p) throw std::bad_alloc();
    return p;
}
[[gnu::noinline]] void release(void* p) noexcept { std::free(p); }
}  // namespace

void* operator new(std::size_t size) { return allocate(size, 1); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size, 1); }
void* operator new(std::size_t size, std::align_val_t a) { return allocate(size, static_cast<std::size_t>(a)); }
void operator delete(void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }

using namespace RTT;

namespace {

typedef std::vector<double> Samples;

template <class F>
unsigned allocationsOf(F f) {
    allocations = 0;
    watching = true;
    f();
    watching = false;
    return allocations;
}

}  // namespace

TEST(RealTime, TheCountSeesAnAllocation) {
    Samples kept;
    EXPECT_GE(allocationsOf([&] { kept = Samples(100); }), 1u);
}

class RealTimePath : public testing::TestWithParam<ConnPolicy> {};

TEST_P(RealTimePath, NeverAllocatesOnceSized) {
    const Samples sample(1000, 1.5);
    Samples got = sample;
    OutputPort<Samples> out("out");
    InputPort<Samples> first("first"), second("second");
    out.setDataSample(sample);
    ASSERT_TRUE(out.createConnection(first, GetParam()));
    ASSERT_TRUE(out.createConnection(second, GetParam()));
    EXPECT_EQ(allocationsOf([&] {
                  for (int i = 0; i < 50; ++i) {
                      for (int n = 0; n < i % 6; ++n) (void)out.write(sample);
                      for (int n = 0; n < i % 4; ++n) (void)first.read(got);
                      (void)second.readNewest(got);
                      if (i % 10 == 0) first.clear();
                  }
              }),
              0u);
}

INSTANTIATE_TEST_SUITE_P(AllStorages, RealTimePath,
                         testing::Values(ConnPolicy::data(), ConnPolicy::data(ConnPolicy::LOCKED),
                                         ConnPolicy::data(ConnPolicy::UNSYNC), ConnPolicy::buffer(4),
                                         ConnPolicy::buffer(4, ConnPolicy::LOCKED),
                                         ConnPolicy::buffer(4, ConnPolicy::UNSYNC), ConnPolicy::circularBuffer(4),
                                         ConnPolicy::circularBuffer(4, ConnPolicy::LOCKED),
                                         ConnPolicy::circularBuffer(4, ConnPolicy::UNSYNC)));
