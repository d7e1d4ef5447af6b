// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Files as other writers make them: with and without each part that the format leaves to the writer. These are the cases
// of the test suite of the format, by the names of its parts.
#include "mcap_files.hpp"

#include <reporting/mcap/format.hpp>

#include <string>
#include <vector>

namespace {

using namespace mcap_test;

enum Part : unsigned {
    ch = 1,     // messages are in a chunk
    mx = 2,     // with an index of them behind it
    st = 4,     // statistics
    rsh = 8,    // schemas again in the summary
    rch = 16,   // channels again in the summary
    ax = 32,    // an index of attachments
    mdx = 64,   // an index of metadata
    chx = 128,  // an index of chunks
    sum = 256,  // offsets of the groups of the summary
    pad = 512   // bytes behind the fields of a record that are known
};
constexpr unsigned kAll = 1024;

struct Case {
    const char* name;
    unsigned schemas, messages, attachments, metadata;
};
const Case kCases[] = {{"NoData", 0, 0, 0, 0},       {"OneMessage", 1, 1, 0, 0},
                       {"TenMessages", 1, 10, 0, 0}, {"OneAttachment", 0, 0, 1, 0},
                       {"OneMetadata", 0, 0, 0, 1},  {"OneSchemalessMessage", 0, 1, 0, 0},
                       {"All", 1, 3, 1, 1}};

/** Makes the file of a case by the specification of the format, without our writer. */
class Made {
public:
    Made(const Case& its, unsigned parts) : its_(its), parts_(parts), bytes(std::begin(kMagic), std::end(kMagic)) {
        record(bytes, Op::Header, [](RecordPut& put) { put.text("").text(""); });
        if (!has(ch)) data(bytes);
        if (has(ch) && its.messages != 0) chunk();
        for (unsigned i = 0; i != its.attachments; ++i) attachment();
        for (unsigned i = 0; i != its.metadata; ++i) {
            metadataAt_ = bytes.size();
            record(bytes, Op::Metadata, [](RecordPut& put) { put.text("myMetadata").texts({{"foo", "bar"}}); });
            metadataSize_ = bytes.size() - metadataAt_;
        }
        record(bytes, Op::DataEnd, [](RecordPut& put) { put.number(std::uint32_t(0)); });
        summary();
        bytes.insert(bytes.end(), std::begin(kMagic), std::end(kMagic));
    }

private:
    bool has(Part part) const { return (parts_ & part) != 0; }

    template <class Fill>
    void record(Bytes& out, Op op, Fill fill) {
        RecordPut put(out, op);
        fill(put);
        const bool isPadded = op != Op::Message && op != Op::Chunk && op != Op::Footer;
        if (has(pad) && isPadded) put.number(std::uint8_t(1)).number(std::uint8_t(2)).number(std::uint8_t(3));
        put.end();
    }

    void schema(Bytes& out) {
        record(out, Op::Schema, [](RecordPut& put) {
            put.number(std::uint16_t(1)).text("Example").text("c").text(std::string("\x04\x05\x06"));
        });
    }
    void channel(Bytes& out) {
        record(out, Op::Channel, [this](RecordPut& put) {
            put.number(std::uint16_t(1)).number(static_cast<std::uint16_t>(its_.schemas)).text("example").text("a");
            put.texts({{"foo", "bar"}});
        });
    }
    void data(Bytes& out) {
        if (its_.schemas != 0) schema(out);
        if (its_.messages != 0) channel(out);
        for (unsigned i = 0; i != its_.messages; ++i) {
            offsets_.push_back(out.size());
            record(out, Op::Message, [i](RecordPut& put) {
                put.number(std::uint16_t(1)).number(std::uint32_t(10 + i));
                // The first messages come in another order than their times.
                put.number(std::uint64_t(i < 2 ? 2 - i : i + 1)).number(std::uint64_t(i));
                for (const std::uint8_t byte : {1, 2, 3}) put.number(byte);
            });
        }
    }
    void chunk() {
        Bytes records;
        data(records);
        chunkAt_ = bytes.size();
        record(bytes, Op::Chunk, [&](RecordPut& put) {
            put.number(std::uint64_t(1)).number(std::uint64_t(its_.messages == 1 ? 2 : its_.messages));
            put.number(std::uint64_t(records.size())).number(std::uint32_t(0)).text("");
            put.number(std::uint64_t(records.size()));
            for (const std::uint8_t byte : records) put.number(byte);
        });
        chunkSize_ = bytes.size() - chunkAt_;
        records_ = records.size();
        if (!has(mx)) return;
        indexAt_ = bytes.size();
        record(bytes, Op::MessageIndex, [this](RecordPut& put) {
            put.number(std::uint16_t(1)).number(static_cast<std::uint32_t>(offsets_.size() * 16));
            for (std::size_t i = 0; i != offsets_.size(); ++i)
                put.number(std::uint64_t(i < 2 ? 2 - i : i + 1)).number(std::uint64_t(offsets_[i]));
        });
        indexSize_ = bytes.size() - indexAt_;
    }
    void attachment() {
        attachmentAt_ = bytes.size();
        record(bytes, Op::Attachment, [](RecordPut& put) {
            put.number(std::uint64_t(2)).number(std::uint64_t(1)).text("myFile").text("application/octet-stream");
            put.number(std::uint64_t(3));
            for (const std::uint8_t byte : {1, 2, 3}) put.number(byte);
            put.number(std::uint32_t(0));
        });
        attachmentSize_ = bytes.size() - attachmentAt_;
    }

    template <class Fill>
    void group(Bytes& out, Op op, Bytes& offsets, std::uint64_t begin, Fill fill) {
        const std::size_t at = out.size();
        fill();
        if (out.size() == at || !has(sum)) return;
        record(offsets, Op::SummaryOffset, [&](RecordPut& put) {
            put.number(static_cast<std::uint8_t>(op)).number(begin + at).number(std::uint64_t(out.size() - at));
        });
    }
    void summary() {
        const std::uint64_t begin = bytes.size();
        Bytes out, offsets;
        group(out, Op::Schema, offsets, begin, [&] {
            if (has(rsh) && its_.schemas != 0) schema(out);
        });
        group(out, Op::Channel, offsets, begin, [&] {
            if (has(rch) && its_.messages != 0) channel(out);
        });
        group(out, Op::Statistics, offsets, begin, [&] {
            if (has(st)) statistics(out);
        });
        group(out, Op::MetadataIndex, offsets, begin, [&] {
            if (!has(mdx) || its_.metadata == 0) return;
            record(out, Op::MetadataIndex, [this](RecordPut& put) {
                put.number(std::uint64_t(metadataAt_)).number(std::uint64_t(metadataSize_)).text("myMetadata");
            });
        });
        group(out, Op::AttachmentIndex, offsets, begin, [&] {
            if (!has(ax) || its_.attachments == 0) return;
            record(out, Op::AttachmentIndex, [this](RecordPut& put) {
                put.number(std::uint64_t(attachmentAt_)).number(std::uint64_t(attachmentSize_));
                put.number(std::uint64_t(2)).number(std::uint64_t(1)).number(std::uint64_t(3));
                put.text("myFile").text("application/octet-stream");
            });
        });
        group(out, Op::ChunkIndex, offsets, begin, [&] {
            if (has(chx) && chunkAt_ != 0) chunkIndex(out);
        });
        const std::uint64_t offsetsBegin = offsets.empty() ? 0 : begin + out.size();
        const bool isEmpty = out.empty();
        bytes.insert(bytes.end(), out.begin(), out.end());
        bytes.insert(bytes.end(), offsets.begin(), offsets.end());
        record(bytes, Op::Footer, [&](RecordPut& put) {
            put.number(isEmpty ? std::uint64_t(0) : begin).number(offsetsBegin).number(std::uint32_t(0));
        });
    }
    void statistics(Bytes& out) {
        record(out, Op::Statistics, [this](RecordPut& put) {
            put.number(std::uint64_t(its_.messages)).number(static_cast<std::uint16_t>(its_.schemas));
            put.number(std::uint32_t(its_.messages != 0 ? 1 : 0)).number(std::uint32_t(its_.attachments));
            put.number(std::uint32_t(its_.metadata)).number(std::uint32_t(chunkAt_ != 0 ? 1 : 0));
            put.number(std::uint64_t(1)).number(std::uint64_t(its_.messages));
            put.number(std::uint32_t(its_.messages != 0 ? 10 : 0));
            if (its_.messages != 0) put.number(std::uint16_t(1)).number(std::uint64_t(its_.messages));
        });
    }
    void chunkIndex(Bytes& out) {
        record(out, Op::ChunkIndex, [this](RecordPut& put) {
            put.number(std::uint64_t(1)).number(std::uint64_t(its_.messages == 1 ? 2 : its_.messages));
            put.number(std::uint64_t(chunkAt_)).number(std::uint64_t(chunkSize_));
            put.number(std::uint32_t(has(mx) ? 10 : 0));
            if (has(mx)) put.number(std::uint16_t(1)).number(std::uint64_t(indexAt_));
            put.number(std::uint64_t(indexSize_)).text("");
            put.number(std::uint64_t(records_)).number(std::uint64_t(records_));
        });
    }

    const Case& its_;
    const unsigned parts_;
    std::vector<std::size_t> offsets_;
    std::size_t chunkAt_ = 0, chunkSize_ = 0, records_ = 0, indexAt_ = 0, indexSize_ = 0;
    std::size_t attachmentAt_ = 0, attachmentSize_ = 0, metadataAt_ = 0, metadataSize_ = 0;

public:
    Bytes bytes;
};

std::string nameOf(const Case& its, unsigned parts) {
    const char* const names[] = {"ch", "mx", "st", "rsh", "rch", "ax", "mdx", "chx", "sum", "pad"};
    std::string name = its.name;
    for (std::size_t i = 0; i != std::size(names); ++i)
        if ((parts >> i & 1U) != 0) name += std::string("-") + names[i];
    return name;
}

class Conformance : public testing::TestWithParam<const Case*> {};

TEST_P(Conformance, OfFilesWithAndWithoutEachPart) {
    const Case& its = *GetParam();
    std::vector<std::uint64_t> times;
    for (unsigned i = 0; i != its.messages; ++i) times.push_back(its.messages == 1 ? 2 : i + 1);
    for (unsigned parts = 0; parts != kAll && !HasFailure(); ++parts) {
        SCOPED_TRACE(nameOf(its, parts));
        const Made file(its, parts);
        const Found found(file.bytes);
        EXPECT_TRUE(found.problems.empty() && found.scanned.hasEnd) << testing::PrintToString(codesOf(found.problems));
        EXPECT_EQ(its.schemas, found.schemas.size());
        EXPECT_EQ(its.metadata, found.allMetadata.size());
        EXPECT_EQ(its.messages != 0 ? 1U : 0U, found.channels.size());
        ASSERT_EQ(its.messages, found.messages.size());
        if (its.messages != 0) {
            EXPECT_EQ(Told(1, 10, 2, std::string("\1\2\3")), found.messages[0]);
            EXPECT_EQ("bar", found.channels[0].metadata.at("foo"));
        }
        MemorySource source(file.bytes.data(), file.bytes.size());
        Summary summary;
        EXPECT_FALSE(readSummary(source, summary));
        std::vector<std::uint64_t> read;
        readMessages(
            source, summary, {}, [&](const Message& message) { read.push_back(message.logTime); },
            [](const Problem& problem) { ADD_FAILURE() << problem.line("file"); });
        EXPECT_EQ(times, read);
        MemorySink sink;
        (void)salvage(source, sink);
        EXPECT_EQ(its.messages, Found(sink.bytes).messages.size());
    }
}

INSTANTIATE_TEST_SUITE_P(Case, Conformance,
                         testing::Values(&kCases[0], &kCases[1], &kCases[2], &kCases[3], &kCases[4], &kCases[5],
                                         &kCases[6]),
                         [](const auto& info) { return info.param->name; });

TEST(IndexedReader, TakesMessagesBetweenChunksInTheOrderOfTimes) {
    File file(Compression::None, someMessages(150), 50);
    // Two messages in no chunk, at the times of those in the middle of the second chunk, and before all.
    for (const std::uint64_t time : {std::uint64_t(1705), std::uint64_t(5)}) {
        Bytes loose;
        RecordPut put(loose, Op::Message);
        put.number(std::uint16_t(1)).number(std::uint32_t(99)).number(time).number(time).number(std::uint8_t(7)).end();
        file.bytes().insert(file.bytes().begin() + static_cast<std::ptrdiff_t>(file.chunks[0]), loose.begin(),
                            loose.end());
        // What the end of the file says is of another place now: it is left out.
    }
    Bytes cut(file.bytes().begin(), file.bytes().end());
    const std::size_t footer = cut.size() - sizeof kMagic - kRecordHead - 20;
    for (std::size_t i = 0; i != 20; ++i) cut[footer + kRecordHead + i] = 0;
    MemorySource source(cut.data(), cut.size());
    Summary summary;
    ASSERT_FALSE(readSummary(source, summary));
    std::vector<std::uint64_t> times;
    const auto none = [](const Problem& problem) { ADD_FAILURE() << problem.line("file"); };
    readMessages(
        source, summary, {}, [&](const Message& message) { times.push_back(message.logTime); }, none);
    EXPECT_EQ(152U, times.size());
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_EQ(5U, times.front());
    times.clear();
    readMessages(
        source, summary, {1700, 1720, {1}}, [&](const Message& message) { times.push_back(message.logTime); }, none);
    EXPECT_EQ((std::vector<std::uint64_t>{1700, 1705}), times);
}

}  // namespace
