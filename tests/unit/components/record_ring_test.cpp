// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <reporting/record_ring.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <thread>

namespace {

using OCL::reporting::RecordRing;

std::string popText(RecordRing& ring) {
    std::vector<char> record;
    return ring.pop(record) ? std::string(record.begin(), record.end()) : "(none)";
}

bool push(RecordRing& ring, const std::string& text) { return ring.push(text.data(), text.size()); }

TEST(RecordRing, GivesRecordsBackInOrder) {
    RecordRing ring(1);
    EXPECT_TRUE(ring.empty());
    EXPECT_EQ("(none)", popText(ring));
    EXPECT_TRUE(push(ring, "one"));
    EXPECT_TRUE(push(ring, ""));
    EXPECT_TRUE(push(ring, "three"));
    EXPECT_FALSE(ring.empty());
    EXPECT_EQ("one", popText(ring));
    EXPECT_EQ("", popText(ring));
    EXPECT_EQ("three", popText(ring));
    EXPECT_TRUE(ring.empty());
}

TEST(RecordRing, RefusesWhatDoesNotFitAndTakesItLater) {
    RecordRing ring(4096);
    ASSERT_EQ(4096u, ring.capacity());
    const std::string half(2044, 'x');  // with its length exactly half of it
    EXPECT_TRUE(push(ring, half));
    EXPECT_TRUE(push(ring, half));
    EXPECT_FALSE(push(ring, ""));
    EXPECT_EQ(half, popText(ring));
    EXPECT_TRUE(push(ring, half));
    EXPECT_FALSE(push(ring, half));
    EXPECT_EQ(half, popText(ring));
    EXPECT_EQ(half, popText(ring));
    EXPECT_FALSE(push(ring, std::string(4093, 'y')));
    EXPECT_TRUE(push(ring, std::string(4092, 'y')));
    EXPECT_EQ(std::string(4092, 'y'), popText(ring));
}

TEST(RecordRing, RecordsMayLieAcrossTheEnd) {
    RecordRing ring(4096);
    for (int i = 0; i < 1000; ++i) {
        const std::string text = std::to_string(i) + std::string(static_cast<std::size_t>(i) % 977, 'z');
        ASSERT_TRUE(push(ring, text));
        ASSERT_EQ(text, popText(ring));
    }
}

TEST(RecordRing, NothingIsLostOrMixedBetweenTwoThreads) {
    RecordRing ring(4096);
    constexpr std::uint32_t kRecords = 200000;
    std::thread writer([&ring] {
        char record[64];
        for (std::uint32_t i = 0; i < kRecords; ++i) {
            const std::size_t size = 4 + i % 60;
            std::memset(record, static_cast<int>(i % 251), size);
            std::memcpy(record, &i, 4);
            while (!ring.push(record, size)) std::this_thread::yield();
        }
    });
    std::vector<char> record;
    for (std::uint32_t i = 0; i < kRecords; ++i) {
        while (!ring.pop(record)) std::this_thread::yield();
        std::uint32_t number = 0;
        ASSERT_EQ(4 + i % 60, record.size());
        std::memcpy(&number, record.data(), 4);
        ASSERT_EQ(i, number);
        ASSERT_TRUE(record.size() == 4 || record.back() == static_cast<char>(i % 251));
    }
    writer.join();
    EXPECT_TRUE(ring.empty());
}

}  // namespace
