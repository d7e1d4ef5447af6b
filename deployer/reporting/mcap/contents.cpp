// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "contents.hpp"

#include "summary.hpp"
#include "unindexed.hpp"

#include <algorithm>
#include <utility>

namespace oroforge::mcap {
namespace {

typedef std::function<void(const Problem&)> Report;

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
        finish();
        piece_.offset = offset;
        piece_.length = kRecordHead + record.size();
        inChunk_ = true;
    }
    void chunkEnd() override {
        finish();
        inChunk_ = false;
    }
    void message(const Message& one) override {
        const std::uint64_t size = kMessageHead + one.size;
        if (!inChunk_ && !piece_.addLoose(one.logTime, one.offset, size)) {
            finish();
            (void)piece_.addLoose(one.logTime, one.offset, size);
        }
        const bool isFirst = contents_.counts.empty(), isFirstOfPiece = piece_.channels.empty();
        piece_.start = isFirstOfPiece ? one.logTime : std::min(piece_.start, one.logTime);
        piece_.end = std::max(piece_.end, one.logTime);
        piece_.channels.insert(one.channel);
        contents_.start = isFirst ? one.logTime : std::min(contents_.start, one.logTime);
        contents_.end = std::max(contents_.end, one.logTime);
        ++contents_.counts[one.channel];
    }
    void finish() {
        if (!piece_.channels.empty()) contents_.pieces.push_back(std::move(piece_));
        piece_ = {};
    }

private:
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

/** An index need not repeat what describes the messages. */
bool describesAll(const Summary& summary) {
    return !summary.channels.empty() && summary.channels.size() >= summary.statistics.channels &&
           std::all_of(summary.channels.begin(), summary.channels.end(), [&](const auto& one) {
               return one.second.schema == 0 || summary.schemas.count(one.second.schema) != 0;
           });
}

}  // namespace

Contents readContents(Source& source, const Report& report) {
    Contents contents;
    Summary summary;
    const Problem problem = readSummary(source, summary);
    contents.hasIndex = !problem && describesAll(summary);
    if (contents.hasIndex) {
        contents.pieces = piecesOf(summary, findUnindexed(source, summary, {}, report));
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
    if (problem && !reported) report(problem);
    return contents;
}

}  // namespace oroforge::mcap
