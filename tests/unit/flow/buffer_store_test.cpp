// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The contract of a buffer, run on every implementation of one.
#include "store_cases.hpp"

#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/types/TypeOps.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

using namespace RTT;
using internal::SampleStore;
using internal::StoreSpec;

template <class C>
class BufferStore : public testing::Test {
protected:
    typedef typename C::Type T;
    void make(StoreSpec::Kind kind, std::size_t size, bool oldData = true) {
        StoreSpec spec;
        spec.kind = kind;
        spec.lock = C::lock;
        spec.size = size;
        spec.oldData = oldData;
        spec.held = true;
        store = SampleStore::make(types::typeOps<T>(), spec, nullptr);
    }
    static T text(int i) { return C::sample(i); }
    WriteStatus write(int i) {
        const T s = text(i);
        return store->write(&s);
    }
    FlowStatus read(bool copyOld = true) { return store->read(&out, copyOld); }
    /** Reads a new sample; true if it is number `i`. */
    bool readsNew(int i) { return read() == NewData && out == text(i); }

    std::unique_ptr<SampleStore> store;
    const T untouched = text(20);
    T out = untouched;
};
TYPED_TEST_SUITE(BufferStore, flow_test::StoreCases);

TYPED_TEST(BufferStore, GivesNoDataAndLeavesTheArgumentBeforeTheFirstWrite) {
    this->make(StoreSpec::Buffer, 3);
    EXPECT_EQ(this->read(), NoData);
    EXPECT_EQ(this->out, this->untouched);
}

TYPED_TEST(BufferStore, GivesSamplesInTheOrderOfWriting) {
    this->make(StoreSpec::Buffer, 3);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(this->write(i), WriteSuccess);
    EXPECT_EQ(this->store->size(), 3u);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(this->readsNew(i));
    EXPECT_EQ(this->store->size(), 0u);
}

TYPED_TEST(BufferStore, StaysInOrderOverManyTurns) {
    for (const std::size_t size : {1u, 2u, 3u, 5u, 8u}) {
        this->make(StoreSpec::Buffer, size);
        int written = 0, got = 0;
        for (int round = 0; round < 50; ++round) {
            for (std::size_t n = 0; n < 1 + round % size; ++n) ASSERT_EQ(this->write(written++), WriteSuccess);
            while (got < written) ASSERT_TRUE(this->readsNew(got++));
        }
    }
}

TYPED_TEST(BufferStore, GivesTheLastSampleAsOldWhenEmpty) {
    this->make(StoreSpec::Buffer, 3);
    this->write(1);
    this->write(2);
    this->read();
    this->read();
    this->out = this->untouched;
    EXPECT_EQ(this->read(false), OldData);
    EXPECT_EQ(this->out, this->untouched);
    EXPECT_EQ(this->read(true), OldData);
    EXPECT_EQ(this->out, this->text(2));
    EXPECT_EQ(this->read(true), OldData);
}

TYPED_TEST(BufferStore, KeepsTheLastSampleWhileItFillsAgain) {
    this->make(StoreSpec::Buffer, 2);
    this->write(1);
    this->read();
    this->write(2);
    this->write(3);
    EXPECT_TRUE(this->readsNew(2));
    EXPECT_TRUE(this->readsNew(3));
    EXPECT_EQ(this->read(), OldData);
    EXPECT_EQ(this->out, this->text(3));
}

TYPED_TEST(BufferStore, WithoutOldDataGivesNoDataWhenEmpty) {
    this->make(StoreSpec::Buffer, 3, false);
    this->write(1);
    EXPECT_TRUE(this->readsNew(1));
    this->out = this->untouched;
    EXPECT_EQ(this->read(), NoData);
    EXPECT_EQ(this->out, this->untouched);
}

TYPED_TEST(BufferStore, RefusesTheNewestSampleWhenFull) {
    this->make(StoreSpec::Buffer, 2);
    EXPECT_EQ(this->write(1), WriteSuccess);
    EXPECT_EQ(this->write(2), WriteSuccess);
    EXPECT_EQ(this->write(3), WriteFailure);
    EXPECT_EQ(this->store->dropped(), 1u);
    EXPECT_TRUE(this->readsNew(1));
    EXPECT_EQ(this->write(4), WriteSuccess);
    EXPECT_TRUE(this->readsNew(2));
    EXPECT_TRUE(this->readsNew(4));
    EXPECT_NE(this->read(), NewData);
}

TYPED_TEST(BufferStore, CircularDropsTheOldestSampleWhenFull) {
    this->make(StoreSpec::CircularBuffer, 2);
    for (int i = 1; i <= 5; ++i) EXPECT_EQ(this->write(i), WriteSuccess);
    EXPECT_EQ(this->store->dropped(), 3u);
    EXPECT_TRUE(this->readsNew(4));
    EXPECT_TRUE(this->readsNew(5));
    EXPECT_EQ(this->read(), OldData);
    EXPECT_EQ(this->out, this->text(5));
}

TYPED_TEST(BufferStore, OfSizeZeroRefusesEverything) {
    for (const StoreSpec::Kind kind : {StoreSpec::Buffer, StoreSpec::CircularBuffer}) {
        this->make(kind, 0);
        EXPECT_EQ(this->write(1), WriteFailure);
        EXPECT_EQ(this->read(), NoData);
        EXPECT_EQ(this->store->capacity(), 0u);
    }
}

TYPED_TEST(BufferStore, IsEmptyAfterClear) {
    this->make(StoreSpec::Buffer, 3);
    this->write(1);
    this->read();
    this->write(2);
    this->store->clear();
    EXPECT_EQ(this->read(), NoData);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(this->write(i), WriteSuccess);
    EXPECT_TRUE(this->readsNew(0));
}

TYPED_TEST(BufferStore, NeverDeliversTheSizingSample) {
    this->make(StoreSpec::Buffer, 2);
    this->write(1);
    const auto sizing = this->text(7);
    this->store->setSample(&sizing, true);
    EXPECT_EQ(this->read(), NoData);
    EXPECT_EQ(this->out, this->untouched);
    EXPECT_TRUE(this->store->getSample(&this->out));
    EXPECT_EQ(this->out, sizing);
}

TYPED_TEST(BufferStore, LeavesAHeldSampleInItsPlace) {
    this->make(StoreSpec::Buffer, 2);
    EXPECT_EQ(this->store->readHeld(), nullptr);
    this->write(1);
    this->write(2);
    const void* held = this->store->readHeld();
    ASSERT_TRUE(held);
    EXPECT_EQ(*static_cast<const typename TypeParam::Type*>(held), this->text(1));
    EXPECT_EQ(this->write(3), WriteSuccess);
    EXPECT_EQ(*static_cast<const typename TypeParam::Type*>(held), this->text(1));
    this->store->release(held);
    EXPECT_TRUE(this->readsNew(2));
    EXPECT_TRUE(this->readsNew(3));
}

TYPED_TEST(BufferStore, CountsWhatItHoldsOverManyTurns) {
    this->make(StoreSpec::CircularBuffer, 3);
    for (int i = 0; i < 20; ++i) {
        this->write(i);
        EXPECT_EQ(this->store->size(), static_cast<std::size_t>(i < 2 ? i + 1 : 3));
    }
    this->store->clear();
    EXPECT_EQ(this->store->size(), 0u);
    EXPECT_EQ(this->read(), NoData);
    this->write(1);
    EXPECT_TRUE(this->readsNew(1));
    EXPECT_EQ(this->read(), OldData);
}

TYPED_TEST(BufferStore, GivesWhatWasReadAgainAfterACircularBufferHasOverflowed) {
    this->make(StoreSpec::CircularBuffer, 1);
    this->write(1);
    EXPECT_TRUE(this->readsNew(1));
    for (int i = 2; i <= 4; ++i) this->write(i);
    EXPECT_TRUE(this->readsNew(4));
    this->out = this->untouched;
    EXPECT_EQ(this->read(), OldData);
    EXPECT_EQ(this->out, this->text(4));
}

TYPED_TEST(BufferStore, KeepsTheTimesOfWritesIfAsked) {
    const auto now = [] { return std::chrono::system_clock::now().time_since_epoch() / std::chrono::nanoseconds(1); };
    this->make(StoreSpec::CircularBuffer, 5);
    std::int64_t time = -1;
    EXPECT_NE(this->store->readTimed(&this->out, time), NewData);
    this->write(0);
    EXPECT_EQ(TypeParam::lock == StoreSpec::LockFree, this->store->keepTimes());
    if (TypeParam::lock != StoreSpec::LockFree) return;
    std::vector<std::int64_t> before{0};
    for (int i = 1; i < 50; ++i) {
        this->write(i);
        before.push_back(now());
        // The first one was written before.
        for (int left = i % 7 == 0 ? 5 : 0; left != 0; --left) {
            const int expected = i + 1 - left;
            ASSERT_EQ(NewData, this->store->readTimed(&this->out, time));
            EXPECT_EQ(this->text(expected), this->out);
            EXPECT_LE(time, before[expected]);
            EXPECT_GE(time, before[expected - 1]);
        }
    }
    this->make(StoreSpec::CircularBuffer, 2);
    this->write(0);
    (void)this->store->keepTimes();
    ASSERT_EQ(NewData, this->store->readTimed(&this->out, time));
    EXPECT_EQ(0, time);
}
