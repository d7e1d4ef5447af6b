// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "in_order.hpp"

#include <algorithm>
#include <utility>

namespace oroforge::mcap {

namespace {

/** Messages that are in no chunk are read together, so many bytes at a time. */
constexpr std::uint64_t kLoosePiece = std::uint64_t(1) << 20;

}  // namespace

bool Piece::addLoose(std::uint64_t time, std::uint64_t at, std::uint64_t size) {
    const bool isFirst = length == 0;
    if (!isFirst && (isChunk || at != offset + length || length + size > kLoosePiece)) return false;
    if (isFirst) offset = at;
    isChunk = false;
    start = isFirst ? time : std::min(start, time);
    end = std::max(end, time);
    length += size;
    return true;
}

std::vector<Piece> piecesOf(const Summary& summary, const Unindexed& more) {
    std::vector<Piece> pieces;
    std::set<std::uint64_t> offsets;
    for (const std::vector<ChunkIndex>* const chunks : {&summary.chunks, &more.chunks})
        for (const ChunkIndex& index : *chunks) {
            // A hostile index could name one chunk so often that no memory holds it.
            if (!offsets.insert(index.offset).second) continue;
            Piece piece;
            piece.offset = index.offset;
            piece.length = index.length;
            piece.start = index.head.start;
            piece.end = index.head.end;
            for (const auto& [channel, at] : index.channels) piece.channels.insert(channel);
            pieces.push_back(std::move(piece));
        }
    Piece loose;
    for (const LooseMessage& one : more.messages) {
        if (loose.addLoose(one.time, one.offset, kRecordHead + one.size)) continue;
        pieces.push_back(std::exchange(loose, {}));
        (void)loose.addLoose(one.time, one.offset, kRecordHead + one.size);
    }
    if (loose.length != 0) pieces.push_back(std::move(loose));
    return pieces;
}

struct InOrder::Open : Visitor {
    Open(const Selection& chosen, const Damaged& report) : selection(chosen), damaged(report) {}
    void message(const Message& message) override {
        if (message.logTime < selection.start || message.logTime >= selection.end) return;
        if (!selection.channels.empty() && selection.channels.count(message.channel) == 0) return;
        messages.push_back(message);
        if (isLoose) messages.back().offset += offset;
    }
    void problem(const Problem& problem) override { damaged(problem); }
    std::uint64_t time() const { return messages[at].logTime; }

    const Selection& selection;
    const Damaged& damaged;
    std::uint64_t offset = 0;
    bool isLoose = false;
    ChunkReader chunk;
    std::vector<Message> messages;
    std::size_t at = 0;
};

InOrder::InOrder(Source& source, const std::vector<Piece>& pieces, ChannelIds known, Selection selection,
                 Damaged damaged, const Limits& limits)
    : source_(source), known_(known), selection_(std::move(selection)), damaged_(std::move(damaged)), limits_(limits) {
    for (const Piece& piece : pieces)
        if (isWanted(piece)) waiting_.push_back(piece);
    std::stable_sort(waiting_.begin(), waiting_.end(),
                     [](const Piece& a, const Piece& b) { return a.start < b.start; });
}

InOrder::~InOrder() = default;

bool InOrder::isWanted(const Piece& piece) const {
    if (piece.end < selection_.start || piece.start >= selection_.end) return false;
    // Without an index of its messages, a chunk may have any.
    if (selection_.channels.empty() || piece.channels.empty()) return true;
    return std::any_of(piece.channels.begin(), piece.channels.end(),
                       [&](std::uint16_t one) { return selection_.channels.count(one) != 0; });
}

InOrder::Open* InOrder::earliest() {
    Open* first = nullptr;
    for (Open& one : open_)
        if (!first || one.time() < first->time() || (one.time() == first->time() && one.offset < first->offset))
            first = &one;
    return first;
}

const Message* InOrder::next() {
    if (given_ && ++given_->at == given_->messages.size())
        open_.remove_if([&](const Open& one) { return &one == given_; });
    for (;;) {
        given_ = earliest();
        const bool isLater = next_ == waiting_.size() || (given_ && waiting_[next_].start > given_->time());
        if (isLater) return given_ ? &given_->messages[given_->at] : nullptr;
        open(waiting_[next_++]);
    }
}

void InOrder::open(const Piece& piece) {
    open_.emplace_back(selection_, damaged_);
    Open& one = open_.back();
    one.offset = piece.offset;
    one.isLoose = !piece.isChunk;
    if (read(piece, one)) visitRecords(one.chunk, piece.offset, known_, one);
    std::stable_sort(one.messages.begin(), one.messages.end(),
                     [](const Message& a, const Message& b) { return a.logTime < b.logTime; });
    if (one.messages.empty()) open_.pop_back();
}

bool InOrder::read(const Piece& piece, Open& one) {
    const std::uint64_t size = source_.size();
    const auto fail = [&](const char* code, const char* text) {
        damaged_({code, piece.offset, text});
        return false;
    };
    constexpr const char* kNone = "the index names a chunk here, but there is none";
    std::uint64_t begin = piece.offset, length = piece.length;
    if (piece.isChunk) {
        unsigned char head[kRecordHead];
        if (begin > size || size - begin < sizeof head || !source_.read(begin, head, sizeof head) ||
            head[0] != static_cast<unsigned char>(Op::Chunk))
            return fail("MCP008", kNone);
        begin += sizeof head;
        length = numberAt<std::uint64_t>(head + 1);
    }
    if (begin > size || length > size - begin || length > limits_.largestRecord) return fail("MCP008", kNone);
    Bytes content(static_cast<std::size_t>(length));
    if (!source_.read(begin, content.data(), content.size())) return fail("MCP010", "the file cannot be read here");
    if (!piece.isChunk) {
        one.chunk.take(std::move(content));
        return true;
    }
    const Problem problem = one.chunk.open(content, piece.offset, limits_);
    if (problem) damaged_(problem);
    return !problem;
}

void readMessages(Source& source, const Summary& summary, const Selection& selection,
                  const std::function<void(const Message&)>& visit, const std::function<void(const Problem&)>& damaged,
                  const Limits& limits) {
    const Unindexed more = findUnindexed(source, summary, selection, damaged);
    ChannelIds known = more.channels;
    for (const auto& [id, channel] : summary.channels) (void)known.insert(id);
    // Without them in the index, those of other chunks are unknown: any may be there.
    if (summary.channels.empty()) known.insertAll();
    InOrder messages(source, piecesOf(summary, more), known, selection, damaged, limits);
    while (const Message* const message = messages.next()) visit(*message);
}

}  // namespace oroforge::mcap
