// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "contents.hpp"

#include "summary.hpp"

#include <algorithm>
#include <utility>

namespace oroforge::mcap {
namespace {

typedef std::function<void(const Problem&)> Report;

/** Messages that are in no chunk are read together, so many bytes at a time. */
constexpr std::uint64_t kLoosePiece = std::uint64_t(1) << 20;
/** No metadata are larger. */
constexpr std::uint64_t kLargestMetadata = std::uint64_t(1) << 24;

class Scanning : public Visitor {
public:
    Scanning(Contents& contents, const Report& report) : contents_(contents), report_(report) {}

    void schema(const Schema& one) override { contents_.schemas.emplace(one.id, one); }
    void channel(const Channel& one) override { contents_.channels.emplace(one.id, one); }
    void metadata(const Metadata& one) override { contents_.metadata.push_back(one); }
    void problem(const Problem& one) override { report_(one); }

    void chunk(const ChunkHead&, const Bytes& record, std::uint64_t offset) override {
        piece_ = {offset, kRecordHead + record.size(), 0, 0, {}, true};
        inChunk_ = true;
    }
    void chunkEnd() override {
        finish();
        inChunk_ = false;
    }
    void message(const Message& one) override {
        if (!inChunk_) addLoose(one);
        if (piece_.channels.empty() || one.logTime < piece_.start) piece_.start = one.logTime;
        piece_.end = std::max(piece_.end, one.logTime);
        piece_.channels.insert(one.channel);
        const bool isFirst = contents_.counts.empty();
        contents_.start = isFirst ? one.logTime : std::min(contents_.start, one.logTime);
        contents_.end = std::max(contents_.end, one.logTime);
        ++contents_.counts[one.channel];
    }
    void finish() {
        if (!piece_.channels.empty()) contents_.pieces.push_back(std::exchange(piece_, {}));
        piece_ = {};
    }

private:
    void addLoose(const Message& one) {
        const std::uint64_t length = kMessageHead + one.size;
        const bool isNext = !piece_.channels.empty() && one.offset == piece_.offset + piece_.length;
        if (!isNext || piece_.length + length > kLoosePiece) {
            finish();
            piece_.offset = one.offset;
            piece_.isChunk = false;
        }
        piece_.length += length;
    }

    Contents& contents_;
    const Report& report_;
    Piece piece_;
    bool inChunk_ = false;
};

/** What an index says of metadata is only where they are. */
void readMetadata(Source& source, const Summary& summary, Contents& contents, const Report& report) {
    for (const MetadataIndex& index : summary.metadata) {
        unsigned char head[kRecordHead];
        const std::uint64_t size = source.size();
        const bool isThere = index.offset < size && size - index.offset >= sizeof head &&
                             source.read(index.offset, head, sizeof head) &&
                             head[0] == static_cast<unsigned char>(Op::Metadata);
        const auto length = isThere ? numberAt<std::uint64_t>(head + 1) : 0;
        Metadata metadata;
        if (isThere && length <= std::min(size - index.offset - sizeof head, kLargestMetadata)) {
            Bytes content(static_cast<std::size_t>(length));
            if (source.read(index.offset + sizeof head, content.data(), content.size()) &&
                get(Cursor(content.data(), content.size()), metadata)) {
                contents.metadata.push_back(std::move(metadata));
                continue;
            }
        }
        report({"MCP008", index.offset, "the index names metadata here, but there are none"});
    }
}

}  // namespace

Contents readContents(Source& source, const Report& report) {
    Contents contents;
    Summary summary;
    const Problem problem = readSummary(source, summary);
    contents.hasIndex = !problem && !summary.chunks.empty() && !summary.channels.empty();
    if (contents.hasIndex) {
        contents.pieces = piecesOf(summary);
        contents.schemas = std::move(summary.schemas);
        contents.channels = std::move(summary.channels);
        contents.counts = summary.statistics.ofChannel;
        contents.start = ~std::uint64_t(0);
        for (const Piece& piece : contents.pieces) {
            if (piece.end == 0) continue;  // it has no messages
            contents.start = std::min(contents.start, piece.start);
            contents.end = std::max(contents.end, piece.end);
        }
        readMetadata(source, summary, contents, report);
        return contents;
    }
    bool reported = false;
    const Report note = [&](const Problem& one) {
        reported = true;
        report(one);
    };
    Scanning scanning(contents, note);
    (void)scan(source, scanning);
    scanning.finish();
    // Of a file that is not whole, scan() says why.
    if (problem && !reported && !summary.isAbsent) report(problem);
    return contents;
}

}  // namespace oroforge::mcap
