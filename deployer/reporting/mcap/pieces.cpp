// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "pieces.hpp"

#include "format.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace oroforge::mcap {
namespace {

/** Messages that are in no chunk are read together, so many bytes at a time. */
constexpr std::uint64_t kLargestLoose = std::uint64_t(1) << 20;

class Walk {
public:
    Walk(Source& source, const std::vector<ChunkIndex>& chunks, const std::function<void(const Problem&)>& damaged,
         Pieces& found)
        : source_(source), chunks_(chunks), damaged_(damaged), found_(found) {}

    void run() {
        at_ = sizeof kMagic;
        while (at_ < source_.size() && (passIndexed() || record())) {
        }
    }

private:
    /** Goes behind the chunk that begins here, and behind the index of its messages. */
    bool passIndexed() {
        while (next_ != chunks_.size() && chunks_[next_].offset < at_) ++next_;
        if (next_ == chunks_.size() || chunks_[next_].offset != at_) return false;
        const std::uint64_t left = source_.size() - at_;
        const std::uint64_t length = chunks_[next_].length, more = chunks_[next_].indexLength;
        if (length < kRecordHead || length > left || more > left - length) return false;
        at_ += length + more;
        return true;
    }

    /** Any other record. False if it is the last one, or the place of the next one is unknown. */
    bool record() {
        constexpr std::size_t kTimes = 16, kMessage = 22;
        const std::uint64_t left = source_.size() - at_;
        unsigned char head[kRecordHead + kMessage];
        const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(left, sizeof head));
        if (size < kRecordHead || !source_.read(at_, head, size)) return fail("the file cannot be read here");
        const auto op = static_cast<Op>(head[0]);
        const auto length = numberAt<std::uint64_t>(head + 1);
        if (op == Op::DataEnd || op == Op::Footer) return false;
        const bool isInTheWay = next_ != chunks_.size() && length > chunks_[next_].offset - at_ - kRecordHead;
        if (head[0] == 0 || length > left - kRecordHead || isInTheWay) return fail("no whole record begins here");
        Cursor content(head + kRecordHead, static_cast<std::size_t>(std::min<std::uint64_t>(length, kMessage)));
        if (op == Op::Channel && length >= 2) found_.channels.insert(content.number<std::uint16_t>());
        if (op == Op::Message && length >= kMessage) addMessage(content, kRecordHead + length);
        if (op == Op::Chunk && length >= kTimes) {
            const auto start = content.number<std::uint64_t>();
            found_.all.push_back({at_, kRecordHead + length, start, content.number<std::uint64_t>(), {}, true});
        }
        at_ += kRecordHead + length;
        return true;
    }

    void addMessage(Cursor content, std::uint64_t length) {
        const auto channel = content.number<std::uint16_t>();
        (void)content.number<std::uint32_t>();  // the sequence number
        found_.addLoose(at_, length, content.number<std::uint64_t>(), channel);
    }

    /** Goes on at the next chunk that the index names. False if there is none. */
    bool fail(const char* why) {
        damaged_({"MCP005", at_, why});
        while (next_ != chunks_.size() && chunks_[next_].offset <= at_) ++next_;
        if (next_ == chunks_.size()) return false;
        at_ = chunks_[next_].offset;
        return true;
    }

    Source& source_;
    const std::vector<ChunkIndex>& chunks_;
    const std::function<void(const Problem&)>& damaged_;
    Pieces& found_;
    std::uint64_t at_ = 0;
    std::size_t next_ = 0;  // among the chunks
};

}  // namespace

void Pieces::addLoose(std::uint64_t offset, std::uint64_t length, std::uint64_t time, std::uint16_t channel) {
    if (Piece* const last = all.empty() ? nullptr : &all.back();
        last && !last->isChunk && last->offset + last->length == offset && last->length + length <= kLargestLoose) {
        last->length += length;
        last->start = std::min(last->start, time);
        last->end = std::max(last->end, time);
        last->channels.insert(channel);
    } else {
        all.push_back({offset, length, time, time, {channel}, false});
    }
}

std::vector<Piece> namedPieces(const Summary& summary) {
    std::vector<Piece> pieces;
    std::set<std::uint64_t> offsets;
    for (const ChunkIndex& index : summary.chunks) {
        // A hostile index could name one chunk so often that no memory holds it.
        if (!offsets.insert(index.offset).second) continue;
        Piece piece{index.offset, index.length, index.head.start, index.head.end, {}, true};
        for (const auto& [channel, at] : index.channels) piece.channels.insert(channel);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

Pieces findPieces(Source& source, const Summary& summary, const std::function<void(const Problem&)>& damaged) {
    Pieces found;
    found.all = namedPieces(summary);
    Walk(source, summary.chunks, damaged, found).run();
    const auto place = [](const Piece& a, const Piece& b) { return a.offset < b.offset; };
    std::stable_sort(found.all.begin(), found.all.end(), place);
    // One that the index names with a wrong length has been found again.
    const auto isSame = [](const Piece& a, const Piece& b) { return a.offset == b.offset; };
    found.all.erase(std::unique(found.all.begin(), found.all.end(), isSame), found.all.end());
    for (const auto& [id, channel] : summary.channels) found.channels.insert(id);
    // Without them in the index, those of other chunks are unknown: any may be there.
    if (summary.channels.empty()) found.channels.insertAll();
    return found;
}

}  // namespace oroforge::mcap
