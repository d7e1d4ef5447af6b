// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "scan.hpp"

#include "compression.hpp"
#include "crc32.hpp"
#include "summary.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace oroforge::mcap {
namespace {

std::string bytesOf(std::uint64_t count) { return std::to_string(count) + (count == 1 ? " byte" : " bytes"); }

Problem lengthProblem(std::uint64_t offset) {
    return {"MCP005", offset, "a length in this record is larger than the bytes that are left of it"};
}

/** Visits a record that is no chunk; a problem if it is damaged. `inChunk` is its place there. */
Problem visitRecord(Op op, Cursor content, std::uint64_t offset, std::uint64_t inChunk, ChannelIds& known,
                    Visitor& visitor, const FindChannels& find) {
    switch (op) {
        case Op::Header: {
            Header header;
            if (!get(content, header)) return lengthProblem(offset);
            visitor.header(header);
            return {};
        }
        case Op::Schema: {
            Schema schema;
            if (!get(content, schema)) return lengthProblem(offset);
            visitor.schema(schema);
            return {};
        }
        case Op::Channel: {
            Channel channel;
            if (!get(content, channel)) return lengthProblem(offset);
            known.insert(channel.id);
            visitor.channel(channel);
            return {};
        }
        case Op::Message: {
            Message message;
            if (!get(content, message)) return lengthProblem(offset);
            if (!known.has(message.channel) && find) find();
            if (!known.has(message.channel)) {
                if (!known.report(message.channel)) return {};
                return {"MCP007", offset,
                        "messages belong to channel " + std::to_string(message.channel) +
                            ", which no record before them describes"};
            }
            message.offset = inChunk;
            visitor.message(message);
            return {};
        }
        case Op::Metadata: {
            Metadata metadata;
            if (!get(content, metadata)) return lengthProblem(offset);
            visitor.metadata(metadata);
            return {};
        }
        default: return {};  // indexes, and what later versions of the format add
    }
}

class Scanner {
public:
    Scanner(Source& source, Visitor& visitor, const Limits& limits)
        : source_(source), visitor_(visitor), limits_(limits) {}

    Scanned run() {
        unsigned char magic[sizeof kMagic];
        if (source_.size() < sizeof magic || !source_.read(0, magic, sizeof magic) ||
            !std::equal(std::begin(magic), std::end(magic), std::begin(kMagic))) {
            report({"MCP001", 0, "this is not an MCAP file: it does not begin with the bytes 89 4d 43 41 50 30 0d 0a"});
            return result_;
        }
        at_ = result_.whole = sizeof magic;
        crc_ = crc32(magic, sizeof magic);
        while (!result_.hasEnd && (next() || skip())) {
        }
        return result_;
    }

private:
    void report(const Problem& problem) {
        ++result_.problems;
        visitor_.problem(problem);
    }
    bool fail(const char* code, const std::string& text) {
        report({code, at_, text});
        return false;
    }

    /** False if the place of the record after this one is unknown. */
    bool next() {
        const std::uint64_t left = source_.size() - at_;
        unsigned char head[kRecordHead];
        if (left < kRecordHead)
            return fail("MCP002", left == 0 ? "the file ends without its index: the recorder was killed, or still runs"
                                            : "the file ends within the head of a record");
        if (!source_.read(at_, head, sizeof head)) return fail("MCP010", "the file cannot be read here");
        const auto op = static_cast<Op>(head[0]);
        const auto length = numberAt<std::uint64_t>(head + 1);
        if (head[0] == 0) return fail("MCP005", "no record begins here: its kind is 0");
        if (length > left - kRecordHead)
            return fail("MCP002", "a record of " + bytesOf(length) + " begins here, but the file ends after " +
                                      bytesOf(left - kRecordHead));
        const std::uint64_t begin = at_;
        if (op == Op::DataEnd) {
            if (!checkAll(length)) return false;
            result_.hasEnd = true;
        } else {
            crc_ = crc32(head, sizeof head, crc_);
            if (!(isRead(op) ? read(op, begin, length) : passBy(length))) return false;
        }
        at_ = result_.whole = begin + kRecordHead + length;
        return true;
    }

    /** Adds the content of a record to the checksum. */
    bool passBy(std::uint64_t length) {
        constexpr std::uint64_t kBlock = std::uint64_t(1) << 16;
        for (std::uint64_t done = 0; done != length;) {
            content_.resize(static_cast<std::size_t>(std::min(length - done, kBlock)));
            if (!source_.read(at_ + kRecordHead + done, content_.data(), content_.size()))
                return fail("MCP010", "the file cannot be read here");
            crc_ = crc32(content_.data(), content_.size(), crc_);
            done += content_.size();
        }
        return true;
    }

    /** Compares the checksum of all records before the DataEnd record with the one that is in it. */
    bool checkAll(std::uint64_t length) {
        unsigned char content[4];
        if (length < sizeof content) {
            report(lengthProblem(at_));
            return true;
        }
        if (!source_.read(at_ + kRecordHead, content, sizeof content))
            return fail("MCP010", "the file cannot be read here");
        const auto crc = numberAt<std::uint32_t>(content);
        if (crc != 0 && crc != crc_ && result_.problems == 0)
            report({"MCP003", at_,
                    "the checksum of all records before this one is wrong, while those of the chunks are right: the "
                    "description of a channel, an index or metadata have changed since they were written"});
        return true;
    }

    static bool isRead(Op op) {
        return op == Op::Header || op == Op::Schema || op == Op::Channel || op == Op::Message || op == Op::Chunk ||
               op == Op::Metadata;
    }

    bool read(Op op, std::uint64_t begin, std::uint64_t length) {
        if (length > limits_.largestRecord) {
            report({"MCP005", begin, "a record of " + bytesOf(length) + " is larger than this reader takes"});
            return true;
        }
        content_.resize(static_cast<std::size_t>(length));
        if (!source_.read(begin + kRecordHead, content_.data(), content_.size()))
            return fail("MCP010", "the file cannot be read here");
        crc_ = crc32(content_.data(), content_.size(), crc_);
        const Problem problem = op == Op::Chunk ? chunk_.open(content_, begin, limits_)
                                                : visitRecord(op, {content_.data(), content_.size()}, begin, begin,
                                                              known_, visitor_, find_);
        if (problem) report(problem);
        if (problem && (op == Op::Schema || op == Op::Channel))
            useSummary();
        else if (!problem && op == Op::Chunk)
            visitChunk(begin);
        return true;
    }

    void visitChunk(std::uint64_t begin) {
        visitor_.chunk(chunk_.head(), content_, begin);
        Counting counting(visitor_, result_.problems);
        visitRecords(chunk_, begin, known_, counting, find_);
        visitor_.chunkEnd();
    }

    /** Goes on behind what is damaged, at a chunk that the index names; false if there is none. */
    bool skip() {
        useSummary();
        for (const ChunkIndex& index : summary_->chunks)
            if (index.offset > at_ && index.offset < source_.size()) {
                at_ = index.offset;
                return true;
            }
        return false;
    }

    /** The schemas and channels may be in what is damaged. */
    void useSummary() {
        if (summary_) return;
        summary_.reset(new Summary);
        if (readSummary(source_, *summary_)) *summary_ = {};
        for (const auto& [id, schema] : summary_->schemas) visitor_.schema(schema);
        for (const auto& [id, channel] : summary_->channels)
            if (known_.insert(id)) visitor_.channel(channel);
    }

    /** Passes everything on and counts the problems. */
    class Counting : public Visitor {
    public:
        Counting(Visitor& to, std::uint64_t& problems) : to_(to), problems_(problems) {}
        void schema(const Schema& schema) override { to_.schema(schema); }
        void channel(const Channel& channel) override { to_.channel(channel); }
        void message(const Message& message) override { to_.message(message); }
        void problem(const Problem& problem) override {
            ++problems_;
            to_.problem(problem);
        }

    private:
        Visitor& to_;
        std::uint64_t& problems_;
    };

    Source& source_;
    Visitor& visitor_;
    const Limits limits_;
    Scanned result_;
    std::uint64_t at_ = 0;
    std::uint32_t crc_ = 0;  // of all bytes so far
    Bytes content_;
    ChunkReader chunk_;
    ChannelIds known_;
    std::unique_ptr<Summary> summary_;
    const FindChannels find_ = [this] { useSummary(); };
};

}  // namespace

Scanned scan(Source& source, Visitor& visitor, const Limits& limits) { return Scanner(source, visitor, limits).run(); }

Problem ChunkReader::open(const Bytes& content, std::uint64_t offset, const Limits& limits) {
    Cursor cursor(content.data(), content.size());
    if (!getHead(cursor, head_)) return lengthProblem(offset);
    const unsigned char* const packed = cursor.take(head_.packedSize);
    if (!packed) return lengthProblem(offset);
    if (!canDecompress(head_.compression))
        return {"MCP004", offset, "the chunk is compressed by '" + head_.compression + "', which cannot be read"};
    if (head_.size > limits.largestChunk)
        return {"MCP005", offset, "a chunk of " + bytesOf(head_.size) + " is larger than this reader takes"};
    std::string why;
    if (!decompress(head_.compression, packed, static_cast<std::size_t>(head_.packedSize), head_.size, records_, why))
        return {"MCP006", offset, "the chunk cannot be decompressed: " + why};
    if (head_.crc != 0 && crc32(records_.data(), records_.size()) != head_.crc)
        return {"MCP003", offset, "the checksum of the chunk is wrong: its bytes have changed since it was written"};
    return {};
}

void visitRecords(const ChunkReader& chunk, std::uint64_t offset, ChannelIds& known, Visitor& visitor,
                  const FindChannels& find) {
    const Bytes& records = chunk.records();
    Cursor cursor(records.data(), records.size());
    known.beginChunk();
    while (cursor.left() != 0) {
        const std::size_t at = cursor.position();
        const auto op = static_cast<Op>(cursor.number<std::uint8_t>());
        const Cursor content = cursor.part(cursor.number<std::uint64_t>());
        if (!cursor.good()) {
            visitor.problem(lengthProblem(offset));
            return;
        }
        if (op != Op::Schema && op != Op::Channel && op != Op::Message) continue;
        const Problem problem = visitRecord(op, content, offset, at, known, visitor, find);
        if (problem) visitor.problem(problem);
    }
}

}  // namespace oroforge::mcap
