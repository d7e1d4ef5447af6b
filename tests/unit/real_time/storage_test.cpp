// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The public storage classes: as real-time safe as their headers say.
#include <support/real_time_trap.hpp>

#include <rtt/base/BufferLockFree.hpp>
#include <rtt/base/BufferLocked.hpp>
#include <rtt/base/BufferUnSync.hpp>
#include <rtt/base/DataObjectLockFree.hpp>
#include <rtt/base/DataObjectLocked.hpp>
#include <rtt/base/DataObjectUnSync.hpp>

#include <gtest/gtest.h>
#include <vector>

using namespace RTT;
using oroforge::test::expectRealTime;
using oroforge::test::RealTimeTrap;

namespace {

typedef std::vector<double> Samples;
constexpr unsigned kHeap = RealTimeTrap::kAllocation | RealTimeTrap::kRelease;

template <class T>
struct Forbidden {
    static constexpr unsigned kinds = RealTimeTrap::kEverything;
};
template <>
struct Forbidden<base::DataObjectLocked<Samples>> {
    static constexpr unsigned kinds = kHeap;
};
template <>
struct Forbidden<base::BufferLocked<Samples>> {
    static constexpr unsigned kinds = kHeap;
};

template <class D>
class RealTimeDataObject : public testing::Test {
protected:
    void SetUp() override { OROFORGE_NEEDS_REAL_TIME_TRAP(); }
};
template <class B>
using RealTimeBuffer = RealTimeDataObject<B>;

typedef testing::Types<base::DataObjectLockFree<Samples>, base::DataObjectLocked<Samples>,
                       base::DataObjectUnSync<Samples>>
    DataObjectTypes;
typedef testing::Types<base::BufferLockFree<Samples>, base::BufferLocked<Samples>, base::BufferUnSync<Samples>>
    BufferTypes;

}  // namespace

TYPED_TEST_SUITE(RealTimeDataObject, DataObjectTypes);
TYPED_TEST(RealTimeDataObject, GetsSetsAndClears) {
    const Samples sample(100, 1.5);
    Samples got = sample;
    TypeParam object(sample);
    expectRealTime(
        [&] {
            for (int i = 0; i < 20; ++i) {
                object.Set(sample);
                object.Get(got);
                object.Get(got, i % 2 == 0);
                if (i == 10) object.clear();
            }
        },
        Forbidden<TypeParam>::kinds);
    EXPECT_EQ(got, sample);
}

template <class B>
class RealTimeBuffers : public RealTimeDataObject<B> {};
TYPED_TEST_SUITE(RealTimeBuffers, BufferTypes);
TYPED_TEST(RealTimeBuffers, PushPopHoldAndClear) {
    const Samples sample(100, 1.5);
    Samples got = sample;
    for (bool circular : {false, true}) {
        TypeParam buffer(4, sample, base::BufferBase::Options().circular(circular));
        expectRealTime(
            [&] {
                for (int i = 0; i < 40; ++i) {
                    for (int n = 0; n < i % 6; ++n) (void)buffer.Push(sample);
                    for (int n = 0; n < i % 4; ++n) (void)buffer.Pop(got);
                    if (Samples* held = buffer.PopWithoutRelease()) buffer.Release(held);
                    (void)(buffer.size() + buffer.capacity() + buffer.dropped() + buffer.empty() + buffer.full());
                    if (i % 10 == 0) buffer.clear();
                }
            },
            Forbidden<TypeParam>::kinds);
        EXPECT_EQ(got, sample);
    }
}
