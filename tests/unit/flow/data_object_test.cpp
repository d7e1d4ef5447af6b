// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The public storage classes, as users have them as members: one contract for every class and kind of sample. What they
// are faces of is tested in data_store_test and buffer_store_test.
#include "store_cases.hpp"

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/BufferLockFree.hpp>
#include <rtt/base/BufferLocked.hpp>
#include <rtt/base/BufferUnSync.hpp>
#include <rtt/base/DataObjectLockFree.hpp>
#include <rtt/base/DataObjectLocked.hpp>
#include <rtt/base/DataObjectUnSync.hpp>

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

using namespace RTT;
using flow_test::Big;

namespace {
template <class T>
T number(int i) {
    return flow_test::value(static_cast<T*>(nullptr), i);
}
}  // namespace

template <class D>
class DataObjects : public testing::Test {
protected:
    typedef typename D::value_t T;
    T got = number<T>(9);
};
typedef testing::Types<base::DataObjectLockFree<double>, base::DataObjectLockFree<std::string>,
                       base::DataObjectLockFree<Big>, base::DataObjectLocked<double>,
                       base::DataObjectLocked<std::string>, base::DataObjectUnSync<double>,
                       base::DataObjectUnSync<std::string>>
    DataObjectTypes;
TYPED_TEST_SUITE(DataObjects, DataObjectTypes);

TYPED_TEST(DataObjects, HoldOneSample) {
    typedef typename TypeParam::value_t T;
    TypeParam object(number<T>(0));
    EXPECT_EQ(object.Get(this->got), NoData);
    EXPECT_EQ(this->got, number<T>(9));
    EXPECT_TRUE(object.Set(number<T>(1)));
    EXPECT_TRUE(object.Set(number<T>(2)));
    EXPECT_EQ(object.Get(this->got), NewData);
    EXPECT_EQ(this->got, number<T>(2));
    this->got = number<T>(9);
    EXPECT_EQ(object.Get(this->got, false), OldData);
    EXPECT_EQ(this->got, number<T>(9));
    EXPECT_EQ(object.Get(this->got), OldData);
    EXPECT_EQ(this->got, number<T>(2));
    EXPECT_EQ(object.Get(), number<T>(2));
    object.clear();
    EXPECT_EQ(object.Get(this->got), NoData);
}

TYPED_TEST(DataObjects, AreSizedByASampleThatIsNoData) {
    typedef typename TypeParam::value_t T;
    TypeParam initialised(number<T>(3)), object;
    EXPECT_EQ(initialised.data_sample(), number<T>(3));
    EXPECT_TRUE(initialised.data_sample(number<T>(4), false));  // has one
    EXPECT_EQ(initialised.data_sample(), number<T>(3));
    EXPECT_TRUE(object.data_sample(number<T>(4), false));
    EXPECT_EQ(object.data_sample(), number<T>(4));
    EXPECT_EQ(object.Get(this->got), NoData);
    object.Set(number<T>(5));
    EXPECT_TRUE(object.data_sample(number<T>(6)));  // starts anew
    EXPECT_EQ(object.data_sample(), number<T>(6));
    EXPECT_EQ(object.Get(this->got), NoData);
}

TYPED_TEST(DataObjects, AreUsedThroughTheirInterface) {
    typedef typename TypeParam::value_t T;
    const typename base::DataObjectInterface<T>::shared_ptr object(
        new TypeParam(number<T>(0), base::DataObjectBase::Options(ConnPolicy::data())));
    const base::DataObjectInterface<T>& reader = *object;
    EXPECT_TRUE(object->Set(number<T>(1)));
    EXPECT_EQ(reader.Get(this->got), NewData);
    EXPECT_EQ(this->got, number<T>(1));
    static_cast<base::DataObjectBase&>(*object).clear();
    EXPECT_EQ(reader.Get(this->got), NoData);
}

template <class B>
class Buffers : public testing::Test {
protected:
    typedef typename B::value_t T;
    T got = number<T>(9);
};
typedef testing::Types<base::BufferLockFree<double>, base::BufferLockFree<std::string>, base::BufferLockFree<Big>,
                       base::BufferLocked<double>, base::BufferLocked<std::string>, base::BufferUnSync<double>,
                       base::BufferUnSync<std::string>>
    BufferTypes;
TYPED_TEST_SUITE(Buffers, BufferTypes);

TYPED_TEST(Buffers, QueueSamples) {
    typedef typename TypeParam::value_t T;
    TypeParam buffer(3);
    EXPECT_TRUE(buffer.empty());
    EXPECT_EQ(buffer.Pop(this->got), NoData);
    EXPECT_EQ(buffer.Push(std::vector<T>{number<T>(1), number<T>(2), number<T>(3), number<T>(4)}), 3);
    EXPECT_TRUE(buffer.full());
    EXPECT_FALSE(buffer.Push(number<T>(5)));
    EXPECT_EQ(buffer.size(), 3);
    EXPECT_EQ(buffer.capacity(), 3);
    EXPECT_EQ(buffer.dropped(), 2);
    EXPECT_EQ(buffer.Pop(this->got), NewData);
    EXPECT_EQ(this->got, number<T>(1));
    T* held = buffer.PopWithoutRelease();
    ASSERT_TRUE(held);
    EXPECT_EQ(*held, number<T>(2));
    buffer.Release(held);
    std::vector<T> rest{number<T>(8)};
    EXPECT_EQ(buffer.Pop(rest), 1);
    EXPECT_EQ(rest, std::vector<T>{number<T>(3)});
    EXPECT_EQ(buffer.Pop(this->got), NoData) << "not OldData, so while (buffer.Pop(x)) ends";
    EXPECT_EQ(buffer.PopWithoutRelease(), nullptr);
    buffer.Push(number<T>(6));
    buffer.clear();
    EXPECT_TRUE(buffer.empty());
}

TYPED_TEST(Buffers, AreDrainedByALoopOverPop) {
    typedef typename TypeParam::value_t T;
    TypeParam buffer(2, number<T>(0), base::BufferBase::Options(true));
    for (int round = 0; round < 2; ++round) {
        for (int i = 1; i <= 3; ++i) buffer.Push(number<T>(i));
        int popped = 0;
        while (popped < 3 && buffer.Pop(this->got)) ++popped;
        EXPECT_EQ(popped, 2);
    }
    EXPECT_EQ(this->got, number<T>(3)) << "left as it was";
    std::vector<T> items{number<T>(8)};
    EXPECT_EQ(buffer.Pop(items), 0);
    EXPECT_TRUE(items.empty());
    buffer.Push(number<T>(4));
    buffer.Release(buffer.PopWithoutRelease());
    EXPECT_EQ(buffer.Pop(this->got), NoData) << "the last one was taken by PopWithoutRelease()";
    buffer.Push(number<T>(5));
    buffer.clear();
    EXPECT_EQ(buffer.Pop(this->got), NoData);
    EXPECT_EQ(this->got, number<T>(3));
}

TYPED_TEST(Buffers, LeaveAloneWhatIsHeld) {
    typedef typename TypeParam::value_t T;
    TypeParam buffer(2, number<T>(0), base::BufferBase::Options(true));
    buffer.Push(number<T>(1));
    buffer.Push(number<T>(2));
    T* const held = buffer.PopWithoutRelease();
    ASSERT_TRUE(held);
    for (int i = 3; i < 10; ++i) buffer.Push(number<T>(i));
    EXPECT_EQ(buffer.Pop(this->got), NewData);
    EXPECT_EQ(this->got, number<T>(8));
    EXPECT_EQ(*held, number<T>(1));
    buffer.Release(held);
}

TYPED_TEST(Buffers, GoOnIfNothingIsReleased) {
    typedef typename TypeParam::value_t T;
    TypeParam buffer(1);
    const bool mustRelease = std::is_same<TypeParam, base::BufferLockFree<T>>::value;
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(buffer.Push(number<T>(i)));
        T* const held = buffer.PopWithoutRelease();
        ASSERT_TRUE(held);
        EXPECT_EQ(*held, number<T>(i));
        if (mustRelease) buffer.Release(held);
    }
}

TYPED_TEST(Buffers, DropTheOldestIfCircular) {
    typedef typename TypeParam::value_t T;
    TypeParam buffer(2, number<T>(0), base::BufferBase::Options(true));
    for (int i = 1; i <= 5; ++i) EXPECT_TRUE(buffer.Push(number<T>(i)));
    std::vector<T> got;
    buffer.Pop(got);
    EXPECT_EQ(got, (std::vector<T>{number<T>(4), number<T>(5)}));
    EXPECT_EQ(buffer.dropped(), 3);
}

TYPED_TEST(Buffers, AreSizedByASampleThatIsNoData) {
    typedef typename TypeParam::value_t T;
    const typename base::BufferInterface<T>::shared_ptr buffer(new TypeParam(2, number<T>(3)));
    EXPECT_EQ(buffer->data_sample(), number<T>(3));
    EXPECT_TRUE(buffer->empty());
    buffer->Push(number<T>(1));
    EXPECT_TRUE(buffer->data_sample(number<T>(4), false));  // has one
    EXPECT_EQ(buffer->data_sample(), number<T>(3));
    EXPECT_EQ(buffer->size(), 1);
    EXPECT_TRUE(buffer->data_sample(number<T>(4)));  // starts anew
    EXPECT_EQ(buffer->data_sample(), number<T>(4));
    EXPECT_TRUE(buffer->empty());
    EXPECT_EQ(buffer->Pop(this->got), NoData);
}

TEST(BufferOptions, ComeFromAPolicy) {
    ConnPolicy policy = ConnPolicy::circularBuffer(3);
    policy.max_threads = 7;
    const base::BufferBase::Options options(policy);
    EXPECT_TRUE(options.circular());
    EXPECT_EQ(options.max_threads(), 7u);
    EXPECT_FALSE(base::BufferBase::Options(ConnPolicy::buffer(3)).circular());
    EXPECT_EQ(base::DataObjectBase::Options(policy).max_threads(), 7u);
}

TEST(BufferOfBool, HoldsBooleans) {
    base::BufferLockFree<bool> buffer(3);
    EXPECT_EQ(buffer.Push(std::vector<bool>{true, false}), 2);
    std::vector<bool> got;
    EXPECT_EQ(buffer.Pop(got), 2);
    EXPECT_EQ(got, (std::vector<bool>{true, false}));
}
