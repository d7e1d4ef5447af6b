// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is written is read again: from the beginning, through the index, and of damaged files what is whole.
#include "mcap_files.hpp"

#include <reporting/mcap/crc32.hpp>

#include <algorithm>
#include <random>

namespace {

using namespace mcap_test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Checksum, IsThatOfZip) {
    EXPECT_EQ(0U, crc32("", 0));
    EXPECT_EQ(0xcbf43926U, crc32("123456789", 9));
    const std::string text = "The quick brown fox jumps over the lazy dog";
    EXPECT_EQ(0x414fa339U, crc32(text.data(), text.size()));
    for (std::size_t i = 0; i != text.size(); ++i)
        EXPECT_EQ(0x414fa339U, crc32(text.data() + i, text.size() - i, crc32(text.data(), i)));
}

TEST(Checksum, IsJoinedOfThoseOfTwoParts) {
    std::mt19937 random(3);
    Bytes bytes(70000);
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random());
    const std::uint32_t all = crc32(bytes.data(), bytes.size());
    for (const std::size_t first : {0UL, 1UL, 17UL, 4096UL, 69999UL, 70000UL}) {
        const std::size_t second = bytes.size() - first;
        EXPECT_EQ(all, crc32Joined(crc32(bytes.data(), first), crc32(bytes.data() + first, second), second)) << first;
    }
}

class Recording : public testing::TestWithParam<Compression> {
protected:
    const std::vector<Told> messages = someMessages(333);
    File file{GetParam(), messages};
};

TEST_P(Recording, IsScanned) {
    const Found found(file.bytes());
    EXPECT_TRUE(found.scanned.hasEnd);
    EXPECT_TRUE(found.problems.empty());
    EXPECT_THAT(found.headers, ElementsAre("ros2"));
    ASSERT_EQ(2U, found.channels.size());
    EXPECT_EQ("/a/first", found.channels[0].topic);
    EXPECT_EQ("m", found.channels[0].metadata.at("unit.x"));
    ASSERT_EQ(1U, found.schemas.size());
    EXPECT_EQ("string data\n", found.schemas[0].data);
    EXPECT_EQ(messages, found.messages);
    ASSERT_EQ(1U, found.allMetadata.size());
    EXPECT_EQ("here", found.allMetadata[0].texts.at("host"));
}

TEST_P(Recording, HasAnIndex) {
    MemorySource source(file.bytes().data(), file.bytes().size());
    Summary summary;
    const Problem problem = readSummary(source, summary);
    ASSERT_FALSE(problem) << problem.text;
    EXPECT_EQ(333U, summary.statistics.messages);
    EXPECT_EQ(167U, summary.statistics.ofChannel[1]);
    EXPECT_EQ(1000U, summary.statistics.start);
    EXPECT_EQ(1000U + 3320, summary.statistics.end);
    EXPECT_EQ(7U, summary.statistics.chunks);
    EXPECT_EQ(1U, summary.metadata.size());
    ASSERT_EQ(file.chunks.size(), summary.chunks.size());
    for (std::size_t i = 0; i != file.chunks.size(); ++i) EXPECT_EQ(file.chunks[i], summary.chunks[i].offset);
    std::vector<Told> read;
    const auto none = [](const Problem& one) { ADD_FAILURE() << one.text; };
    const auto take = [&](const Message& message) { read.push_back(told(message)); };
    readMessages(source, summary, {}, take, none);
    EXPECT_EQ(messages, read);
    read.clear();
    readMessages(source, summary, {1500, 2000, {2}}, take, none);
    std::vector<Told> expected;
    for (const Told& one : messages)
        if (std::get<0>(one) == 2 && std::get<2>(one) >= 1500 && std::get<2>(one) < 2000) expected.push_back(one);
    EXPECT_EQ(expected, read);
}

TEST_P(Recording, IsReadInTheOrderOfTimesThoughChunksOverlap) {
    std::vector<Told> shuffled = messages;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(7));
    File other(GetParam(), shuffled, 20);
    MemorySource source(other.bytes().data(), other.bytes().size());
    Summary summary;
    ASSERT_FALSE(readSummary(source, summary));
    std::vector<Told> read;
    readMessages(
        source, summary, {}, [&](const Message& message) { read.push_back(told(message)); }, [](const Problem&) {});
    EXPECT_EQ(messages, read);
}

TEST_P(Recording, ThatIsCutAnywhereHasAllWholeChunks) {
    for (std::size_t size = 0; size < file.bytes().size(); size += size < 400 ? 1 : 7) {
        const Found found(file.bytes(), size);
        const auto whole = std::count_if(file.chunks.begin(), file.chunks.end(), [&](std::size_t begin) {
            return begin + kRecordHead + numberAt<std::uint64_t>(&file.bytes()[begin + 1]) <= size;
        });
        const std::size_t expected = std::min<std::size_t>(50 * static_cast<std::size_t>(whole), messages.size());
        ASSERT_EQ(expected, found.messages.size()) << size;
        EXPECT_TRUE(std::equal(found.messages.begin(), found.messages.end(), messages.begin()));
        EXPECT_LE(found.scanned.whole, size);
        const std::vector<std::string> code{size < sizeof kMagic ? "MCP001" : "MCP002"};
        ASSERT_EQ(found.scanned.hasEnd ? std::vector<std::string>() : code, codesOf(found.problems)) << size;
    }
}

// The head of a chunk has no checksum, but what is wrong with it shows; an opcode that becomes another one may not.
TEST_P(Recording, ThatIsDamagedAnywhereInAChunkHasNoOtherMessages) {
    std::mt19937 random(11);
    const std::size_t chunk = file.chunks[1], end = kRecordHead + numberAt<std::uint64_t>(&file.bytes()[chunk + 1]);
    for (std::size_t at = 1; at < end; at += at < 60 ? 1 : 1 + random() % 20) {
        Bytes bytes = file.bytes();
        bytes[chunk + at] = static_cast<unsigned char>(bytes[chunk + at] ^ (1U << random() % 8));
        const Found found(bytes);
        EXPECT_GE(found.messages.size(), 283U) << at;
        for (const Told& one : found.messages)
            ASSERT_NE(messages.end(), std::find(messages.begin(), messages.end(), one)) << at;
        MemorySource source(bytes.data(), bytes.size());
        Summary summary;
        ASSERT_FALSE(readSummary(source, summary));
        std::size_t count = 0;
        readMessages(
            source, summary, {},
            [&](const Message& one) {
                ++count;
                EXPECT_NE(messages.end(), std::find(messages.begin(), messages.end(), told(one)));
            },
            [](const Problem&) {});
        EXPECT_GE(count, 283U) << at;
    }
}

TEST_P(Recording, InWhichAnyByteBeforeTheIndexHasChangedIsFoundOut) {
    for (std::size_t at = 0; at < file.dataEnd; at += at < 500 ? 1 : 13) {
        Bytes bytes = file.bytes();
        bytes[at] = static_cast<unsigned char>(bytes[at] ^ (1U << at % 8));
        EXPECT_FALSE(Found(bytes).problems.empty()) << at;
    }
    Bytes bytes = file.bytes();
    const std::string topic = "/a/second";
    *std::search(bytes.begin(), bytes.end(), topic.begin(), topic.end()) = '_';
    const Found found(bytes);
    EXPECT_EQ(messages, found.messages);
    ASSERT_THAT(codesOf(found.problems), ElementsAre("MCP003"));
    EXPECT_EQ(file.dataEnd, found.problems[0].offset);
    EXPECT_THAT(found.problems[0].text, HasSubstr("those of the chunks are right"));
}

TEST_P(Recording, WithADamagedChunkHasTheOthers) {
    Bytes bytes = file.bytes();
    bytes[file.chunks[2] + 100] ^= 1U;
    const Found found(bytes);
    EXPECT_EQ(283U, found.messages.size());
    ASSERT_EQ(1U, found.problems.size());
    EXPECT_EQ(file.chunks[2], found.problems[0].offset);
    EXPECT_THAT(found.problems[0].code, testing::AnyOf(HasSubstr("MCP003"), HasSubstr("MCP006")));
    EXPECT_TRUE(found.scanned.hasEnd);
}

TEST_P(Recording, GoesOnBehindALengthThatIsWrongByItsIndex) {
    Bytes bytes = file.bytes();
    putNumber<std::uint64_t>(&bytes[file.chunks[2] + 1], ~std::uint64_t(0) - 3);
    const Found found(bytes);
    EXPECT_EQ(283U, found.messages.size());
    ASSERT_THAT(codesOf(found.problems), ElementsAre("MCP002"));
    EXPECT_EQ("run.mcap: byte " + std::to_string(file.chunks[2]) +
                  ": error: [MCP002] a record of 18446744073709551612 bytes begins here, but the file ends after " +
                  std::to_string(bytes.size() - file.chunks[2] - 9) + " bytes",
              found.problems[0].line("run.mcap"));
}

TEST_P(Recording, WhoseFirstLengthIsWrongIsReadByItsIndex) {
    Bytes bytes = file.bytes();
    putNumber<std::uint64_t>(&bytes[sizeof kMagic + 1], ~std::uint64_t(0));  // of the header
    const Found found(bytes);
    EXPECT_EQ(messages, found.messages);
    EXPECT_EQ(2U, found.channels.size());
    MemorySource source(bytes.data(), bytes.size());
    MemorySink sink;
    EXPECT_EQ(messages.size(), salvage(source, sink).messages);
    const Found salvaged(sink.bytes);
    EXPECT_TRUE(salvaged.problems.empty() && salvaged.scanned.hasEnd);
    EXPECT_EQ(messages, salvaged.messages);
}

/** With a wrong length in the description of the channel 2, in front of the chunks. */
Bytes withoutChannel(Bytes bytes) {
    const std::string topic = "/a/second";
    const auto at = std::search(bytes.begin(), bytes.end(), topic.begin(), topic.end());
    putNumber<std::uint32_t>(&*at - 4, 1000000);
    return bytes;
}

TEST_P(Recording, TakesADamagedChannelFromItsIndex) {
    const Bytes bytes = withoutChannel(file.bytes());
    const Found found(bytes);
    EXPECT_THAT(codesOf(found.problems), ElementsAre("MCP005"));
    EXPECT_EQ(messages, found.messages);
    MemorySource source(bytes.data(), bytes.size());
    MemorySink sink;
    EXPECT_EQ(messages.size(), salvage(source, sink).messages);
    const Found salvaged(sink.bytes);
    EXPECT_TRUE(salvaged.problems.empty());
    EXPECT_EQ(messages, salvaged.messages);
}

TEST_P(Recording, IsSalvagedWithTheDescriptionsThatHaveAChecksum) {
    Bytes bytes = file.bytes();
    for (const std::string text : {"string data", "/a/second"}) {
        const auto at = std::search(bytes.begin(), bytes.end(), text.begin(), text.end());
        *at = '#';
    }
    MemorySource source(bytes.data(), bytes.size());
    MemorySink sink;
    const Salvaged salvaged = salvage(source, sink);
    EXPECT_THAT(codesOf(salvaged.problems), ElementsAre("MCP003"));
    const Found found(sink.bytes);
    EXPECT_TRUE(found.problems.empty());
    EXPECT_EQ("string data\n", found.schemas.at(0).data);
    EXPECT_EQ("/a/second", found.channels.at(1).topic);
    EXPECT_EQ(messages, found.messages);
}

TEST_P(Recording, IsSalvagedWithoutMessagesThatNothingDescribes) {
    Bytes bytes = withoutChannel(file.bytes());
    bytes.resize(file.dataEnd);
    std::vector<Told> described;
    for (const Told& message : messages)
        if (std::get<0>(message) == 1) described.push_back(message);
    const Found found(bytes);
    EXPECT_THAT(codesOf(found.problems), Contains("MCP007").Times(static_cast<int>(file.chunks.size())));
    EXPECT_EQ(described, found.messages);
    MemorySource source(bytes.data(), bytes.size());
    MemorySink sink;
    EXPECT_EQ(described.size(), salvage(source, sink).messages);
    const Found salvaged(sink.bytes);
    EXPECT_TRUE(salvaged.problems.empty());
    EXPECT_EQ(described, salvaged.messages);
}

TEST_P(Recording, TakesNoMemoryForWhatAChunkPromises) {
    Bytes bytes = file.bytes();
    putNumber<std::uint64_t>(&bytes[file.chunks[1] + kRecordHead + 16], std::uint64_t(1) << 31);  // its size
    const Found found(bytes);
    EXPECT_EQ(283U, found.messages.size());
    ASSERT_THAT(codesOf(found.problems), ElementsAre("MCP006"));
    putNumber<std::uint64_t>(&bytes[file.chunks[1] + kRecordHead + 16], std::uint64_t(1) << 60);
    EXPECT_THAT(codesOf(Found(bytes).problems), ElementsAre("MCP005"));
}

TEST_P(Recording, IsSalvagedWithAMessageBehindAChunk) {
    Bytes bytes = file.bytes();
    bytes.resize(file.chunks[1]);
    Bytes message{static_cast<unsigned char>(Op::Message)};
    message.resize(kRecordHead + 22);
    putNumber<std::uint64_t>(&message[1], 22);
    putNumber<std::uint16_t>(&message[kRecordHead], 1);
    bytes.insert(bytes.end(), message.begin(), message.end());
    const Found found(bytes);
    EXPECT_EQ(51U, found.messages.size());
    MemorySource source(bytes.data(), bytes.size());
    MemorySink sink;
    EXPECT_EQ(51U, salvage(source, sink).messages);
    EXPECT_EQ(found.messages, Found(sink.bytes).messages);
}

TEST_P(Recording, IsSalvaged) {
    Bytes bytes = file.bytes();
    bytes[file.chunks[2] + 100] ^= 1U;
    bytes.resize(file.chunks[5] + 30);
    MemorySource source(bytes.data(), bytes.size());
    MemorySink sink;
    const Salvaged salvaged = salvage(source, sink);
    EXPECT_EQ("", salvaged.error);
    EXPECT_EQ(200U, salvaged.messages);
    EXPECT_EQ(4U, salvaged.chunks);
    EXPECT_EQ(2U, salvaged.problems.size());
    const Found found(sink.bytes);
    EXPECT_TRUE(found.problems.empty());
    EXPECT_TRUE(found.scanned.hasEnd);
    std::vector<Told> expected = messages;
    expected.resize(250);
    expected.erase(expected.begin() + 100, expected.begin() + 150);
    EXPECT_EQ(expected, found.messages);
    MemorySource whole(sink.bytes.data(), sink.bytes.size());
    Summary summary;
    ASSERT_FALSE(readSummary(whole, summary));
    std::vector<Told> read;
    readMessages(
        whole, summary, {}, [&](const Message& one) { read.push_back(told(one)); }, [](const Problem&) {});
    EXPECT_EQ(expected, read);
    // The offsets in the indexes are right, too.
    const std::uint64_t at = summary.chunks[0].channels.at(2);
    Cursor index(&sink.bytes[at + kRecordHead + 6], 16);
    EXPECT_EQ(1010U, index.number<std::uint64_t>());
}

INSTANTIATE_TEST_SUITE_P(With, Recording, testing::ValuesIn(compressions()), [](const auto& info) {
    return info.param == Compression::None ? std::string("None") : std::string(nameOf(info.param));
});

TEST(DamagedFile, OfAnotherKindIsRefused) {
    const std::string text = "TimeStamp a b c\n0 1 2 3\n";
    const Found found(Bytes(text.begin(), text.end()));
    ASSERT_THAT(codesOf(found.problems), ElementsAre("MCP001"));
    EXPECT_EQ(0U, found.scanned.whole);
    EXPECT_THAT(codesOf(Found(Bytes()).problems), ElementsAre("MCP001"));
}

TEST(DamagedFile, UnknownCompressionAndChannelAreReported) {
    File file(Compression::None, someMessages(10));
    PackedChunk packed;
    Chunk chunk(1000);
    ASSERT_TRUE(addTo(chunk, {9, 0, 5, "lost"}));
    std::string why;
    ASSERT_TRUE(packed.pack(chunk, nullptr, why));
    MemorySink sink;
    Writer writer(sink);
    ASSERT_TRUE(writer.begin({}) && writer.write(packed));
    packed.head.compression = "br";
    packed.before.clear();
    put(packed.before, packed.head);
    ASSERT_TRUE(writer.write(packed) && writer.finish());
    const Found found(sink.bytes);
    EXPECT_THAT(codesOf(found.problems), ElementsAre("MCP007", "MCP004"));
    EXPECT_THAT(found.problems[0].text, HasSubstr("channel 9"));
    EXPECT_THAT(found.problems[1].text, HasSubstr("'br'"));
}

TEST(DamagedFile, TextLongerThanItsRecordIsReported) {
    MemorySink sink;
    Writer writer(sink);
    ASSERT_TRUE(writer.begin({"ros2", "x"}));
    const std::size_t begin = sink.bytes.size();
    ASSERT_TRUE(writer.add(Schema{1, "a", "b", "c"}) && writer.finish());
    putNumber<std::uint32_t>(&sink.bytes[begin + kRecordHead + 2], 0xfffffff0U);
    const Found found(sink.bytes);
    ASSERT_THAT(codesOf(found.problems), ElementsAre("MCP005"));
    EXPECT_EQ(begin, found.problems[0].offset);
    ASSERT_EQ(1U, found.schemas.size());  // that of the index
    EXPECT_EQ("a", found.schemas[0].name);
}

TEST(DamagedFile, IndexIsRefusedIfAnyByteOfItHasChanged) {
    File file(Compression::None, someMessages(60));
    for (std::size_t at = file.dataEnd + 13; at != file.bytes().size(); ++at) {
        Bytes bytes = file.bytes();
        bytes[at] ^= 4U;
        MemorySource source(bytes.data(), bytes.size());
        Summary summary;
        EXPECT_TRUE(readSummary(source, summary)) << at;
    }
}

TEST(FullDisk, EndsTheFileWithTheReason) {
    class Full : public MemorySink {
    public:
        std::string write(const Piece* pieces, std::size_t count) override {
            return bytes.size() > 1000 ? "No space left on device" : MemorySink::write(pieces, count);
        }
    };
    Full sink;
    Writer writer(sink);
    ASSERT_TRUE(writer.begin({}));
    PackedChunk packed;
    Chunk chunk(2000);
    std::string why;
    ASSERT_TRUE(addTo(chunk, {1, 0, 5, std::string(1200, 'x')}) && packed.pack(chunk, nullptr, why));
    EXPECT_TRUE(writer.write(packed));
    const std::uint64_t size = writer.offset();
    EXPECT_FALSE(writer.write(packed));
    EXPECT_FALSE(writer.finish());
    EXPECT_EQ("No space left on device", writer.error());
    EXPECT_EQ(size, writer.offset());
    EXPECT_EQ(1U, writer.statistics().messages);
}

}  // namespace
