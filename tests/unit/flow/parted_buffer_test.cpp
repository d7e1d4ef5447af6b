// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A buffer with a part for each processor is, seen from outside, one buffer: first in, first out, all places used, exact
// counts.
#include <rtt/internal/flow/buffer_parts.hpp>
#include <rtt/internal/flow/detail/stores.hpp>
#include <rtt/types/TypeOps.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <sched.h>

using namespace RTT;
using internal::SampleStore;
using internal::StoreSpec;

namespace {

struct Entry {
    unsigned writer = 0;
    std::uint64_t serial = 0;
    std::string text;
};

std::unique_ptr<SampleStore> makeStore(std::size_t size, bool oldData = true) {
    StoreSpec spec;
    spec.kind = StoreSpec::Buffer;
    spec.size = size;
    spec.maxThreads = internal::kThreadsOfParts;
    spec.oldData = oldData;
    return internal::detail::makePartedBuffer(types::typeOps<Entry>(), spec, nullptr);
}

/** Continues on that processor if the process has it. */
void moveTo(unsigned processor) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(processor, &set);
    (void)sched_setaffinity(0, sizeof set, &set);
}

bool put(SampleStore& store, std::uint64_t serial) {
    Entry entry;
    entry.serial = serial;
    entry.text = "a text that is too long to be stored in place: " + std::to_string(serial);
    return store.write(&entry) == WriteSuccess;
}

std::uint64_t take(SampleStore& store) {
    Entry entry;
    return store.read(&entry, true) == NewData ? entry.serial : 0;
}

class PartedBuffer : public testing::Test {
protected:
    PartedBuffer() { sched_getaffinity(0, sizeof before_, &before_); }
    ~PartedBuffer() override { sched_setaffinity(0, sizeof before_, &before_); }
    cpu_set_t before_;
};

TEST_F(PartedBuffer, HasOnePartUnlessThereAreProcessorsAndPlacesForMore) {
    EXPECT_EQ(internal::bufferParts(1), 1u);
    EXPECT_EQ(internal::bufferParts(15), 1u);
    EXPECT_LE(internal::bufferParts(1000000), 8u);
    EXPECT_EQ(internal::bufferParts(2000000), 1u);
    if (std::thread::hardware_concurrency() > 1) {
        EXPECT_GE(internal::bufferParts(16), 2u);
    }
}

TEST_F(PartedBuffer, OneThreadUsesAllPlacesWithoutParts) {
    const auto store = makeStore(100);
    for (std::uint64_t serial = 1; serial <= 100; ++serial) EXPECT_TRUE(put(*store, serial));
    EXPECT_FALSE(put(*store, 101));
    for (std::uint64_t serial = 1; serial <= 100; ++serial) ASSERT_EQ(take(*store), serial);
    EXPECT_EQ(store->dropped(), 1u);
}

/** Writes and takes on two processors in turn until the buffer must have seen it. */
void divide(SampleStore& store) {
    for (std::uint64_t serial = 1; serial <= 40; ++serial) {
        moveTo(static_cast<unsigned>(serial % 2));
        ASSERT_TRUE(put(store, serial));
        ASSERT_EQ(take(store), serial);
    }
}

TEST_F(PartedBuffer, AThreadThatMovesUsesAllPlacesInOrder) {
    for (const std::size_t size : {1u, 16u, 17u, 100u}) {
        const auto store = makeStore(size);
        EXPECT_EQ(store->capacity(), size);
        divide(*store);
        for (int round = 0; round < 3; ++round) {
            for (std::uint64_t serial = 1; serial <= size; ++serial) {
                moveTo(static_cast<unsigned>(serial % 3 ? 0 : 1));
                EXPECT_TRUE(put(*store, serial)) << size;
            }
            EXPECT_EQ(store->size(), size);
            EXPECT_FALSE(put(*store, size + 1));
            EXPECT_EQ(store->dropped(), static_cast<std::size_t>(round + 1));
            for (std::uint64_t serial = 1; serial <= size; ++serial) ASSERT_EQ(take(*store), serial) << size;
            EXPECT_EQ(take(*store), 0u);
            EXPECT_EQ(store->size(), 0u);
        }
    }
}

TEST_F(PartedBuffer, EmptyGivesTheLastSampleAgainUntilItIsCleared) {
    const auto store = makeStore(32);
    Entry entry;
    EXPECT_EQ(store->read(&entry, true), NoData);
    for (std::uint64_t serial = 1; serial <= 4; ++serial) {
        moveTo(static_cast<unsigned>(serial % 2));
        ASSERT_TRUE(put(*store, serial));
        EXPECT_EQ(take(*store), serial);
        EXPECT_EQ(store->read(&entry, true), OldData);
        EXPECT_EQ(entry.serial, serial);
    }
    ASSERT_TRUE(put(*store, 5));
    store->clear();
    EXPECT_EQ(store->read(&entry, true), NoData);
    const auto without = makeStore(32, false);
    ASSERT_TRUE(put(*without, 1));
    EXPECT_EQ(take(*without), 1u);
    EXPECT_EQ(without->read(&entry, true), NoData);
}

/** The parts come into use at any moment of such a burst, in which nothing is taken out. */
TEST_F(PartedBuffer, OrderIsKeptWhenThePartsComeIntoUse) {
    const auto store = makeStore(64);
    for (std::uint64_t serial = 1; serial <= 60; ++serial) {
        moveTo(static_cast<unsigned>(serial % 2));
        ASSERT_TRUE(put(*store, serial));
    }
    for (std::uint64_t serial = 1; serial <= 60; ++serial) ASSERT_EQ(take(*store), serial);
    EXPECT_EQ(take(*store), 0u);
}

TEST_F(PartedBuffer, PreparedSamplesAreInAllParts) {
    const auto store = makeStore(64);
    divide(*store);
    Entry sample;
    sample.text.assign(500, 'x');
    store->setSample(&sample, true);
    Entry again;
    ASSERT_TRUE(store->getSample(&again));
    EXPECT_EQ(again.text, sample.text);
}

/** Eight threads that move from processor to processor, and a reader that is too slow for them. */
TEST_F(PartedBuffer, StormKeepsTheOrderOfEachThreadAndCountsWhatItRefuses) {
    constexpr unsigned kWriters = 8;
    constexpr std::uint64_t kEach = 20000;
    const auto store = makeStore(64);
    std::atomic<unsigned> writing{kWriters};
    std::vector<std::uint64_t> written(kWriters);
    std::vector<std::thread> threads;
    for (unsigned w = 0; w < kWriters; ++w)
        threads.emplace_back([&, w] {
            Entry entry;
            entry.writer = w;
            for (entry.serial = 1; entry.serial <= kEach; ++entry.serial) {
                if (entry.serial % 1000 == w) moveTo(static_cast<unsigned>(entry.serial / 1000 % 2));
                entry.text = "writer " + std::to_string(w) + ", number " + std::to_string(entry.serial);
                if (store->write(&entry) == WriteSuccess) ++written[w];
                if (entry.serial % 64 == 0) std::this_thread::yield();
            }
            --writing;
        });
    std::vector<std::uint64_t> got(kWriters), last(kWriters);
    Entry entry;
    for (;;) {
        const bool done = writing == 0;
        if (store->read(&entry, false) != NewData) {
            if (done) break;
            std::this_thread::yield();
            continue;
        }
        ASSERT_LT(entry.writer, kWriters);
        EXPECT_EQ(entry.text, "writer " + std::to_string(entry.writer) + ", number " + std::to_string(entry.serial));
        EXPECT_GT(entry.serial, last[entry.writer]) << "writer " << entry.writer;
        last[entry.writer] = entry.serial;
        ++got[entry.writer];
    }
    for (std::thread& thread : threads) thread.join();
    std::uint64_t sum = 0;
    for (const std::uint64_t each : written) sum += each;
    EXPECT_EQ(got, written);
    EXPECT_EQ(sum + store->dropped(), kWriters * kEach);
    EXPECT_GT(sum, 0u);
}

/** A sample that is written after another thread has written one comes after it. */
TEST_F(PartedBuffer, WhatOneThreadWritesAfterAnotherComesAfterIt) {
    constexpr std::uint64_t kRounds = 20000;
    const auto store = makeStore(64);
    std::atomic<std::uint64_t> turn{0};  // the number that was written last
    std::vector<std::thread> threads;
    for (unsigned w = 0; w < 2; ++w)
        threads.emplace_back([&, w] {
            moveTo(w);
            for (std::uint64_t serial = 1 + w; serial <= kRounds; serial += 2) {
                while (turn.load(std::memory_order_acquire) != serial - 1) sched_yield();
                while (!put(*store, serial)) sched_yield();
                turn.store(serial, std::memory_order_release);
            }
        });
    std::uint64_t expected = 1;
    while (expected <= kRounds) {
        const std::uint64_t serial = take(*store);
        if (serial == 0) {
            sched_yield();
            continue;
        }
        ASSERT_EQ(serial, expected);
        ++expected;
    }
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
