// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The public storage classes: thin faces of the storage that data_store_test and buffer_store_test test.
#include <rtt/base/BufferLockFree.hpp>
#include <rtt/base/BufferLocked.hpp>
#include <rtt/base/BufferUnSync.hpp>
#include <rtt/base/DataObjectLockFree.hpp>
#include <rtt/base/DataObjectLocked.hpp>
#include <rtt/base/DataObjectUnSync.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace RTT;

template <class D>
class DataObjects : public testing::Test {};
typedef testing::Types<base::DataObjectLockFree<std::string>, base::DataObjectLocked<std::string>,
                       base::DataObjectUnSync<std::string>>
    DataObjectTypes;
TYPED_TEST_SUITE(DataObjects, DataObjectTypes);

TYPED_TEST(DataObjects, HoldOneSample) {
    TypeParam object("initial");
    std::string got = "untouched";
    EXPECT_EQ(object.Get(got), NoData);
    EXPECT_EQ(got, "untouched");
    EXPECT_EQ(object.Get(), "");
    EXPECT_EQ(object.data_sample(), "initial");
    EXPECT_TRUE(object.Set("a"));
    EXPECT_TRUE(object.Set("b"));
    EXPECT_EQ(object.Get(got), NewData);
    EXPECT_EQ(got, "b");
    EXPECT_EQ(object.Get(got, false), OldData);
    EXPECT_EQ(object.Get(), "b");
    object.clear();
    EXPECT_EQ(object.Get(got), NoData);
}

template <class B>
class Buffers : public testing::Test {};
typedef testing::Types<base::BufferLockFree<int>, base::BufferLocked<int>, base::BufferUnSync<int>> BufferTypes;
TYPED_TEST_SUITE(Buffers, BufferTypes);

TYPED_TEST(Buffers, QueueSamples) {
    TypeParam buffer(3);
    EXPECT_TRUE(buffer.empty());
    EXPECT_EQ(buffer.Push(std::vector<int>{1, 2, 3, 4}), 3);
    EXPECT_TRUE(buffer.full());
    EXPECT_FALSE(buffer.Push(5));
    EXPECT_EQ(buffer.size(), 3);
    EXPECT_EQ(buffer.capacity(), 3);
    EXPECT_EQ(buffer.dropped(), 2);
    int got = 0;
    EXPECT_EQ(buffer.Pop(got), NewData);
    EXPECT_EQ(got, 1);
    int* held = buffer.PopWithoutRelease();
    ASSERT_TRUE(held);
    EXPECT_EQ(*held, 2);
    buffer.Release(held);
    std::vector<int> rest{9};
    EXPECT_EQ(buffer.Pop(rest), 1);
    EXPECT_EQ(rest, std::vector<int>{3});
    EXPECT_NE(buffer.Pop(got), NewData);
    EXPECT_EQ(buffer.PopWithoutRelease(), nullptr);
}

TYPED_TEST(Buffers, DropTheOldestIfCircular) {
    TypeParam buffer(2, 0, base::BufferBase::Options(true));
    for (int i = 1; i <= 5; ++i) EXPECT_TRUE(buffer.Push(i));
    std::vector<int> got;
    buffer.Pop(got);
    EXPECT_EQ(got, (std::vector<int>{4, 5}));
    EXPECT_EQ(buffer.dropped(), 3);
}

TEST(Buffers, HoldBooleans) {
    base::BufferLockFree<bool> buffer(3);
    EXPECT_EQ(buffer.Push(std::vector<bool>{true, false}), 2);
    std::vector<bool> got;
    EXPECT_EQ(buffer.Pop(got), 2);
    EXPECT_EQ(got, (std::vector<bool>{true, false}));
}
