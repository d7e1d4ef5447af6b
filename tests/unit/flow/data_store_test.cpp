// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The contract of a data object, run on every implementation of one.
#include "store_cases.hpp"

#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/types/TypeOps.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

using namespace RTT;
using internal::SampleStore;
using internal::StoreSpec;

template <class C>
class DataStore : public testing::Test {
protected:
    typedef typename C::Type T;
    static T sample(int i) { return C::sample(i); }
    static std::unique_ptr<SampleStore> make() {
        StoreSpec spec;
        spec.lock = C::lock;
        return SampleStore::make(types::typeOps<T>(), spec, nullptr);
    }
    bool write(int i) {
        const T s = sample(i);
        return store->write(&s) == WriteSuccess;
    }
    FlowStatus read(bool copyOld = true) { return store->read(&out, copyOld); }

    std::unique_ptr<SampleStore> store = make();
    T out = sample(9);
};

TYPED_TEST_SUITE(DataStore, flow_test::StoreCases);

TYPED_TEST(DataStore, GivesNoDataAndLeavesTheArgumentBeforeTheFirstWrite) {
    EXPECT_EQ(this->read(), NoData);
    EXPECT_EQ(this->out, this->sample(9));
    EXPECT_EQ(this->store->size(), 0u);
}

TYPED_TEST(DataStore, GivesASampleAsNewOnceAndThenAsOld) {
    ASSERT_TRUE(this->write(1));
    EXPECT_EQ(this->store->size(), 1u);
    EXPECT_EQ(this->read(), NewData);
    EXPECT_EQ(this->out, this->sample(1));
    this->out = this->sample(9);
    EXPECT_EQ(this->read(), OldData);
    EXPECT_EQ(this->out, this->sample(1));
    EXPECT_EQ(this->store->size(), 0u);
}

TYPED_TEST(DataStore, CopiesOldDataOnlyIfAsked) {
    this->write(1);
    this->read();
    this->out = this->sample(9);
    EXPECT_EQ(this->read(false), OldData);
    EXPECT_EQ(this->out, this->sample(9));
}

TYPED_TEST(DataStore, CopiesNewDataAlsoIfOldOneIsNotWanted) {
    this->write(1);
    EXPECT_EQ(this->read(false), NewData);
    EXPECT_EQ(this->out, this->sample(1));
}

TYPED_TEST(DataStore, KeepsOnlyTheLastOfManyWrites) {
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(this->write(i % 7));
    EXPECT_EQ(this->read(), NewData);
    EXPECT_EQ(this->out, this->sample(19 % 7));
    EXPECT_EQ(this->read(), OldData);
}

TYPED_TEST(DataStore, IsNewAgainIfTheSameValueIsWrittenAgain) {
    this->write(1);
    this->read();
    this->write(1);
    EXPECT_EQ(this->read(), NewData);
}

TYPED_TEST(DataStore, ForgetsTheSampleOnClear) {
    this->write(1);
    this->read();
    this->store->clear();
    this->out = this->sample(9);
    EXPECT_EQ(this->read(), NoData);
    EXPECT_EQ(this->out, this->sample(9));
    this->write(2);
    EXPECT_EQ(this->read(), NewData);
    EXPECT_EQ(this->out, this->sample(2));
}

TYPED_TEST(DataStore, NeverDeliversTheSizingSample) {
    const auto sizing = this->sample(5);
    this->store->setSample(&sizing, true);
    EXPECT_EQ(this->read(), NoData);
    EXPECT_EQ(this->out, this->sample(9));
    EXPECT_TRUE(this->store->getSample(&this->out));
    EXPECT_EQ(this->out, sizing);
}

TYPED_TEST(DataStore, ForgetsASampleWhenSizedAnewButNotWhenAlreadySized) {
    const auto sizing = this->sample(5);
    this->store->setSample(&sizing, false);
    this->write(1);
    this->store->setSample(&sizing, false);
    EXPECT_EQ(this->read(), NewData);
    this->store->setSample(&sizing, true);
    EXPECT_EQ(this->read(), NoData);
}

TEST(SampleStore, IsRefusedForATypeWithoutDefaultValueUnlessItGetsAFirstSample) {
    struct NoDefault {
        explicit NoDefault(int v) : value(v) {}
        ~NoDefault() {}
        int value;
    };
    StoreSpec spec;
    EXPECT_EQ(SampleStore::make(types::typeOps<NoDefault>(), spec, nullptr), nullptr);
    NoDefault first(3);
    const auto store = SampleStore::make(types::typeOps<NoDefault>(), spec, &first);
    ASSERT_TRUE(store);
    first.value = 4;
    store->write(&first);
    NoDefault out(0);
    EXPECT_EQ(store->read(&out, true), NewData);
    EXPECT_EQ(out.value, 4);
}

TEST(SampleStore, SurvivesASampleThatCannotBeAssigned) {
    struct Thrower {
        Thrower() = default;
        Thrower(const Thrower&) = default;
        Thrower& operator=(const Thrower& o) {
            if (o.value < 0) throw 1;
            value = o.value;
            return *this;
        }
        int value = 0;
    };
    for (const StoreSpec::Kind kind : {StoreSpec::Data, StoreSpec::Buffer}) {
        StoreSpec spec;
        spec.kind = kind;
        spec.size = 2;
        const auto store = SampleStore::make(types::typeOps<Thrower>(), spec, nullptr);
        Thrower good, bad, out;
        good.value = 7;
        bad.value = -1;
        for (int i = 0; i < 100; ++i) EXPECT_THROW(store->write(&bad), int);
        EXPECT_EQ(store->write(&good), WriteSuccess);
        EXPECT_EQ(store->read(&out, true), NewData);
        EXPECT_EQ(out.value, 7);
    }
}

TYPED_TEST(DataStore, NumbersItsSamples) {
    EXPECT_EQ(0U, this->store->newest());
    std::set<std::uint64_t> numbers;
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(this->write(1));
        numbers.insert(this->store->newest());
        if (i % 3 == 0) (void)this->read();
        EXPECT_EQ(1U, numbers.count(this->store->newest())) << "reading makes no other sample";
    }
    const bool counts = TypeParam::lock == StoreSpec::LockFree;
    EXPECT_EQ(counts ? 100U : 1U, numbers.size());
    EXPECT_EQ(counts ? 0U : 1U, numbers.count(0));
    this->store->clear();
    EXPECT_EQ(0U, this->store->newest());
}
