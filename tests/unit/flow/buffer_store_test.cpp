// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The contract of a buffer, run on every implementation of one.
#include <rtt/internal/SampleStore.hpp>
#include <rtt/types/TypeOps.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <string>

using namespace RTT;
using internal::SampleStore;
using internal::StoreSpec;

class BufferStore : public testing::TestWithParam<StoreSpec::Lock> {
protected:
    void make(StoreSpec::Kind kind, std::size_t size, bool oldData = true) {
        StoreSpec spec;
        spec.kind = kind;
        spec.lock = GetParam();
        spec.size = size;
        spec.oldData = oldData;
        store = SampleStore::make(types::typeOps<std::string>(), spec, nullptr);
    }
    WriteStatus write(int i) {
        const std::string s = text(i);
        return store->write(&s);
    }
    FlowStatus read(bool copyOld = true) { return store->read(&out, copyOld); }
    static std::string text(int i) { return "a string too long to be stored in place, number " + std::to_string(i); }
    /** Reads a new sample and tells its number, or -1. */
    int readNumber() {
        if (read() != NewData) return -1;
        return std::stoi(out.substr(out.rfind(' ')));
    }

    std::unique_ptr<SampleStore> store;
    std::string out = "untouched";
};

static std::string nameOf(const testing::TestParamInfo<StoreSpec::Lock>& info) {
    return info.param == StoreSpec::Unsync ? "UnSync" : info.param == StoreSpec::Locked ? "Locked" : "LockFree";
}
INSTANTIATE_TEST_SUITE_P(AllLocks, BufferStore,
                         testing::Values(StoreSpec::Unsync, StoreSpec::Locked, StoreSpec::LockFree), nameOf);

TEST_P(BufferStore, GivesNoDataAndLeavesTheArgumentBeforeTheFirstWrite) {
    make(StoreSpec::Buffer, 3);
    EXPECT_EQ(read(), NoData);
    EXPECT_EQ(out, "untouched");
}

TEST_P(BufferStore, GivesSamplesInTheOrderOfWriting) {
    make(StoreSpec::Buffer, 3);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(write(i), WriteSuccess);
    EXPECT_EQ(store->size(), 3u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(readNumber(), i);
    EXPECT_EQ(store->size(), 0u);
}

TEST_P(BufferStore, StaysInOrderOverManyTurns) {
    for (const std::size_t size : {1u, 2u, 3u, 5u, 8u}) {
        make(StoreSpec::Buffer, size);
        int written = 0, got = 0;
        for (int round = 0; round < 50; ++round) {
            for (std::size_t n = 0; n < 1 + round % size; ++n) ASSERT_EQ(write(written++), WriteSuccess);
            while (got < written) ASSERT_EQ(readNumber(), got++);
        }
    }
}

TEST_P(BufferStore, GivesTheLastSampleAsOldWhenEmpty) {
    make(StoreSpec::Buffer, 3);
    write(1);
    write(2);
    read();
    read();
    out = "untouched";
    EXPECT_EQ(read(false), OldData);
    EXPECT_EQ(out, "untouched");
    EXPECT_EQ(read(true), OldData);
    EXPECT_EQ(out, text(2));
    EXPECT_EQ(read(true), OldData);
}

TEST_P(BufferStore, KeepsTheLastSampleWhileItFillsAgain) {
    make(StoreSpec::Buffer, 2);
    write(1);
    read();
    write(2);
    write(3);
    EXPECT_EQ(readNumber(), 2);
    EXPECT_EQ(readNumber(), 3);
    EXPECT_EQ(read(), OldData);
    EXPECT_EQ(out, text(3));
}

TEST_P(BufferStore, WithoutOldDataGivesNoDataWhenEmpty) {
    make(StoreSpec::Buffer, 3, false);
    write(1);
    EXPECT_EQ(readNumber(), 1);
    out = "untouched";
    EXPECT_EQ(read(), NoData);
    EXPECT_EQ(out, "untouched");
}

TEST_P(BufferStore, RefusesTheNewestSampleWhenFull) {
    make(StoreSpec::Buffer, 2);
    EXPECT_EQ(write(1), WriteSuccess);
    EXPECT_EQ(write(2), WriteSuccess);
    EXPECT_EQ(write(3), WriteFailure);
    EXPECT_EQ(store->dropped(), 1u);
    EXPECT_EQ(readNumber(), 1);
    EXPECT_EQ(write(4), WriteSuccess);
    EXPECT_EQ(readNumber(), 2);
    EXPECT_EQ(readNumber(), 4);
    EXPECT_EQ(readNumber(), -1);
}

TEST_P(BufferStore, CircularDropsTheOldestSampleWhenFull) {
    make(StoreSpec::CircularBuffer, 2);
    for (int i = 1; i <= 5; ++i) EXPECT_EQ(write(i), WriteSuccess);
    EXPECT_EQ(store->dropped(), 3u);
    EXPECT_EQ(readNumber(), 4);
    EXPECT_EQ(readNumber(), 5);
    EXPECT_EQ(read(), OldData);
    EXPECT_EQ(out, text(5));
}

TEST_P(BufferStore, OfSizeZeroRefusesEverything) {
    for (const StoreSpec::Kind kind : {StoreSpec::Buffer, StoreSpec::CircularBuffer}) {
        make(kind, 0);
        EXPECT_EQ(write(1), WriteFailure);
        EXPECT_EQ(read(), NoData);
        EXPECT_EQ(store->capacity(), 0u);
    }
}

TEST_P(BufferStore, IsEmptyAfterClear) {
    make(StoreSpec::Buffer, 3);
    write(1);
    read();
    write(2);
    store->clear();
    EXPECT_EQ(read(), NoData);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(write(i), WriteSuccess);
    EXPECT_EQ(readNumber(), 0);
}

TEST_P(BufferStore, NeverDeliversTheSizingSample) {
    make(StoreSpec::Buffer, 2);
    write(1);
    const std::string sizing = "sizing sample";
    store->setSample(&sizing, true);
    EXPECT_EQ(read(), NoData);
    EXPECT_EQ(out, "untouched");
    EXPECT_TRUE(store->getSample(&out));
    EXPECT_EQ(out, sizing);
}

TEST_P(BufferStore, LeavesAHeldSampleInItsPlace) {
    make(StoreSpec::Buffer, 2);
    EXPECT_EQ(store->readHeld(), nullptr);
    write(1);
    write(2);
    const void* held = store->readHeld();
    ASSERT_TRUE(held);
    EXPECT_EQ(*static_cast<const std::string*>(held), text(1));
    EXPECT_EQ(write(3), WriteSuccess);
    EXPECT_EQ(*static_cast<const std::string*>(held), text(1));
    store->release(held);
    EXPECT_EQ(readNumber(), 2);
    EXPECT_EQ(readNumber(), 3);
}
