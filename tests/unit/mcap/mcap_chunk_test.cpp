// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A message costs no memory and no lock, and a chunk says when it is full.
#include "mcap_files.hpp"

#include <support/real_time_trap.hpp>

namespace {

using namespace mcap_test;
using oroforge::test::expectRealTime;

TEST(FullChunk, TakesMessagesAgainWhenItIsCleared) {
    Chunk chunk(1000);
    for (int round = 0; round != 3; ++round) {
        std::uint32_t count = 0;
        while (addTo(chunk, {1, count, count, "0123456789"})) ++count;
        EXPECT_EQ(1000 / (kMessageHead + 10), count);
        EXPECT_EQ(count, chunk.entries().size());
        chunk.clear();
        EXPECT_TRUE(chunk.empty());
    }
    EXPECT_EQ(nullptr, chunk.place(1000));
    EXPECT_EQ(nullptr, chunk.place(~std::size_t(0)));
    chunk.grow(1000);
    EXPECT_TRUE(addTo(chunk, {1, 0, 0, std::string(1000, 'x')}));
    EXPECT_FALSE(addTo(chunk, {1, 1, 0, ""}));
}

TEST(FullChunk, HasTheTimesOfItsMessagesInAnyOrder) {
    Chunk chunk(1000);
    for (const std::uint64_t time : {50U, 20U, 90U}) ASSERT_TRUE(addTo(chunk, {1, 0, time, ""}));
    EXPECT_EQ(20U, chunk.start());
    EXPECT_EQ(90U, chunk.end());
    chunk.clear();
    ASSERT_TRUE(addTo(chunk, {1, 0, 70, ""}));
    EXPECT_EQ(70U, chunk.start());
    EXPECT_EQ(70U, chunk.end());
}

TEST(FullChunk, WasFilledWithoutAllocation) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    Chunk chunk(1 << 16);
    const Told message{1, 0, 1, "some"};
    for (int round = 0; round != 2; ++round) {
        std::size_t count = 0;
        expectRealTime([&] {
            while (addTo(chunk, message)) ++count;
        });
        EXPECT_GT(count, 1800U);
        chunk.clear();
    }
}

TEST(PackedChunk, KeepsItsMemory) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    for (const Compression compression : compressions()) {
        if (compression == Compression::Lz4) continue;  // takes a context for each block
        std::unique_ptr<Compressor> compressor;
        if (compression != Compression::None) compressor.reset(new Compressor(compression));
        Chunk chunk(1 << 14);
        PackedChunk packed;
        std::string why;
        while (addTo(chunk, {3, 0, 1, "some"})) {
        }
        ASSERT_TRUE(packed.pack(chunk, compressor.get(), why));
        oroforge::test::RealTimeTrap trap(oroforge::test::RealTimeTrap::kAllocation);
        EXPECT_TRUE(packed.pack(chunk, compressor.get(), why));
        trap.stop();
        EXPECT_LE(trap.caught(), 1U) << nameOf(compression);  // the number of messages of each channel
        trap.forgive();
    }
}

TEST(PackedChunk, OutlivesItsMessagesOnceItOwnsThem) {
    for (const Compression compression : compressions()) {
        std::unique_ptr<Compressor> compressor;
        if (compression != Compression::None) compressor.reset(new Compressor(compression));
        Chunk chunk(1000);
        PackedChunk packed;
        std::string why;
        ASSERT_TRUE(addTo(chunk, {1, 0, 1, "kept"}) && packed.pack(chunk, compressor.get(), why));
        packed.own();
        chunk.clear();
        ASSERT_TRUE(addTo(chunk, {1, 0, 1, "gone"}));
        MemorySink sink;
        Writer writer(sink);
        ASSERT_TRUE(writer.begin({}) && writer.add(Channel{1, 0, "/a", "", {}}) && writer.write(packed));
        const Found found(sink.bytes);
        ASSERT_EQ(1U, found.messages.size());
        EXPECT_EQ("kept", std::get<3>(found.messages[0]));
    }
}

}  // namespace
