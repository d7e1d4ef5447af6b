// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "summary.hpp"

#include "crc32.hpp"

#include <algorithm>
#include <list>

namespace oroforge::mcap {
namespace {

constexpr std::size_t kFooter = kRecordHead + 20;

Problem damaged(std::uint64_t offset, const std::string& what) {
    return {"MCP008", offset, "the index at the end of the file is damaged: " + what};
}

/** False if a length of the record is wrong. */
bool take(Op op, Cursor content, Summary& summary) {
    switch (op) {
        case Op::Schema: {
            Schema schema;
            if (!get(content, schema)) return false;
            summary.schemas[schema.id] = schema;
            return true;
        }
        case Op::Channel: {
            Channel channel;
            if (!get(content, channel)) return false;
            summary.channels[channel.id] = channel;
            return true;
        }
        case Op::ChunkIndex: summary.chunks.emplace_back(); return get(content, summary.chunks.back());
        case Op::MetadataIndex: summary.metadata.emplace_back(); return get(content, summary.metadata.back());
        case Op::Statistics: return get(content, summary.statistics);
        default: return true;
    }
}

}  // namespace

Problem readSummary(Source& source, Summary& summary, const Limits& limits) {
    summary = {};
    const std::uint64_t size = source.size();
    unsigned char end[kFooter + sizeof kMagic];
    if (size < sizeof kMagic + sizeof end || !source.read(size - sizeof end, end, sizeof end) ||
        !std::equal(std::begin(kMagic), std::end(kMagic), end + kFooter) ||
        end[0] != static_cast<unsigned char>(Op::Footer) || numberAt<std::uint64_t>(end + 1) != kFooter - kRecordHead)
        return {"MCP002", size, "the file ends without its index: the recorder was killed, or still runs"};
    const std::uint64_t footer = size - sizeof end;
    const auto begin = numberAt<std::uint64_t>(end + kRecordHead);
    if (begin == 0) return damaged(footer, "it is empty");
    if (begin < sizeof kMagic || begin > footer)
        return damaged(footer, "it would begin at byte " + std::to_string(begin));
    if (footer - begin > limits.largestRecord) return damaged(begin, "it is larger than this reader takes");
    Bytes bytes(static_cast<std::size_t>(footer - begin));
    if (!source.read(begin, bytes.data(), bytes.size())) return {"MCP010", begin, "the file cannot be read here"};
    const auto crc = numberAt<std::uint32_t>(end + kFooter - 4);
    if (crc != 0 && crc32(end, kFooter - 4, crc32(bytes.data(), bytes.size())) != crc)
        return damaged(begin, "its checksum is wrong");
    Cursor cursor(bytes.data(), bytes.size());
    while (cursor.left() != 0) {
        const std::uint64_t at = begin + cursor.position();
        const auto op = static_cast<Op>(cursor.number<std::uint8_t>());
        const Cursor content = cursor.part(cursor.number<std::uint64_t>());
        if (!cursor.good() || !take(op, content, summary))
            return damaged(at, "a length in it is larger than the bytes that are left");
    }
    std::sort(summary.chunks.begin(), summary.chunks.end(),
              [](const ChunkIndex& a, const ChunkIndex& b) { return a.offset < b.offset; });
    return {};
}

namespace {

/** Chunks that overlap in time, and their messages that are still to come. */
class Merge {
public:
    Merge(Source& source, const Summary& summary, const Selection& selection, const Limits& limits)
        : source_(source), selection_(selection), limits_(limits) {
        for (const auto& [id, channel] : summary.channels) known_.insert(id);
        for (const ChunkIndex& index : summary.chunks)
            if (isWanted(index)) waiting_.push_back(&index);
        std::stable_sort(waiting_.begin(), waiting_.end(),
                         [](const ChunkIndex* a, const ChunkIndex* b) { return a->head.start < b->head.start; });
    }

    void run(const std::function<void(const Message&)>& visit, const std::function<void(const Problem&)>& damaged) {
        for (std::size_t next = 0;;) {
            Open* first = earliest();
            if (next != waiting_.size() && (!first || waiting_[next]->head.start <= first->time())) {
                open(*waiting_[next++], damaged);
                continue;
            }
            if (!first) return;
            visit(first->messages[first->at]);
            if (++first->at == first->messages.size()) open_.remove_if([&](const Open& one) { return &one == first; });
        }
    }

private:
    struct Open : Visitor {
        explicit Open(const Selection& chosen, const std::function<void(const Problem&)>& report)
            : selection(chosen), damaged(report) {}
        void message(const Message& message) override {
            if (message.logTime < selection.start || message.logTime >= selection.end) return;
            if (selection.channels.empty() || selection.channels.count(message.channel) != 0)
                messages.push_back(message);
        }
        void problem(const Problem& problem) override { damaged(problem); }
        std::uint64_t time() const { return messages[at].logTime; }

        const Selection& selection;
        const std::function<void(const Problem&)>& damaged;
        std::uint64_t offset = 0;
        ChunkReader chunk;
        std::vector<Message> messages;
        std::size_t at = 0;
    };

    bool isWanted(const ChunkIndex& index) const {
        if (index.head.end < selection_.start || index.head.start >= selection_.end) return false;
        // Without an index of its messages, a chunk may have any.
        if (selection_.channels.empty() || index.channels.empty()) return true;
        return std::any_of(index.channels.begin(), index.channels.end(),
                           [&](const auto& one) { return selection_.channels.count(one.first) != 0; });
    }

    Open* earliest() {
        Open* first = nullptr;
        for (Open& one : open_)
            if (!first || one.time() < first->time() || (one.time() == first->time() && one.offset < first->offset))
                first = &one;
        return first;
    }

    void open(const ChunkIndex& index, const std::function<void(const Problem&)>& damaged) {
        const std::uint64_t size = source_.size();
        unsigned char head[kRecordHead];
        if (index.offset > size || size - index.offset < sizeof head ||
            !source_.read(index.offset, head, sizeof head) || head[0] != static_cast<unsigned char>(Op::Chunk) ||
            numberAt<std::uint64_t>(head + 1) > size - index.offset - sizeof head ||
            numberAt<std::uint64_t>(head + 1) > limits_.largestRecord)
            return damaged({"MCP008", index.offset, "the index names a chunk here, but there is none"});
        Bytes content(static_cast<std::size_t>(numberAt<std::uint64_t>(head + 1)));
        if (!source_.read(index.offset + sizeof head, content.data(), content.size()))
            return damaged({"MCP010", index.offset, "the file cannot be read here"});
        open_.emplace_back(selection_, damaged);
        Open& one = open_.back();
        one.offset = index.offset;
        if (const Problem problem = one.chunk.open(content, index.offset, limits_))
            damaged(problem);
        else
            visitRecords(one.chunk, index.offset, known_, one);
        std::stable_sort(one.messages.begin(), one.messages.end(),
                         [](const Message& a, const Message& b) { return a.logTime < b.logTime; });
        if (one.messages.empty()) open_.pop_back();
    }

    Source& source_;
    const Selection& selection_;
    const Limits limits_;
    std::set<std::uint16_t> known_;
    std::vector<const ChunkIndex*> waiting_;
    std::list<Open> open_;
};

}  // namespace

void readMessages(Source& source, const Summary& summary, const Selection& selection,
                  const std::function<void(const Message&)>& visit, const std::function<void(const Problem&)>& damaged,
                  const Limits& limits) {
    Merge(source, summary, selection, limits).run(visit, damaged);
}

}  // namespace oroforge::mcap
