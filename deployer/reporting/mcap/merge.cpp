// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Messages in the order of times.
#include "summary.hpp"
#include "unindexed.hpp"

#include <algorithm>
#include <list>
#include <string>
#include <utility>

namespace oroforge::mcap {
namespace {

/** Chunks that overlap in time, and their messages that are still to come. */
class Merge {
public:
    Merge(Source& source, const Summary& summary, const Selection& selection,
          const std::function<void(const Problem&)>& damaged, const Limits& limits)
        : source_(source),
          selection_(selection),
          limits_(limits),
          more_(findUnindexed(source, summary, selection, damaged)),
          known_(more_.channels) {
        for (const auto& [id, channel] : summary.channels) known_.insert(id);
        // Without them in the index, those of other chunks are unknown: any may be there.
        if (summary.channels.empty()) known_.insertAll();
        for (const std::vector<ChunkIndex>* const chunks : {&summary.chunks, &std::as_const(more_.chunks)})
            for (const ChunkIndex& index : *chunks)
                if (isWanted(index)) waiting_.push_back(&index);
        std::stable_sort(more_.messages.begin(), more_.messages.end(),
                         [](const LooseMessage& a, const LooseMessage& b) { return a.time < b.time; });
        std::stable_sort(waiting_.begin(), waiting_.end(),
                         [](const ChunkIndex* a, const ChunkIndex* b) { return a->head.start < b->head.start; });
    }

    void run(const std::function<void(const Message&)>& visit, const std::function<void(const Problem&)>& damaged) {
        std::size_t loose = 0;
        for (std::size_t next = 0;;) {
            Open* first = earliest();
            const LooseMessage* const other = loose == more_.messages.size() ? nullptr : &more_.messages[loose];
            const bool isOther = other && (!first || other->time < first->time() ||
                                           (other->time == first->time() && other->offset < first->offset));
            if (next != waiting_.size() &&
                ((!first && !other) || waiting_[next]->head.start <= (isOther ? other->time : first->time()))) {
                open(*waiting_[next++], damaged);
                continue;
            }
            if (isOther) {
                ++loose;
                visitLoose(*other, visit, damaged);
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

    void visitLoose(const LooseMessage& one, const std::function<void(const Message&)>& visit,
                    const std::function<void(const Problem&)>& damaged) {
        if (one.size > limits_.largestRecord)
            return damaged({"MCP005", one.offset, "a record here is larger than this reader takes"});
        content_.resize(static_cast<std::size_t>(one.size));
        Message message;
        if (!source_.read(one.offset + kRecordHead, content_.data(), content_.size()) ||
            !get({content_.data(), content_.size()}, message))
            return damaged({"MCP010", one.offset, "the file cannot be read here"});
        if (!known_.has(message.channel))
            return damaged(
                {"MCP007", one.offset,
                 "a message belongs to channel " + std::to_string(message.channel) + ", which no record describes"});
        message.offset = one.offset;
        visit(message);
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
    Unindexed more_;
    ChannelIds known_;
    Bytes content_;  // of a message in no chunk
    std::vector<const ChunkIndex*> waiting_;
    std::list<Open> open_;
};

}  // namespace

void readMessages(Source& source, const Summary& summary, const Selection& selection,
                  const std::function<void(const Message&)>& visit, const std::function<void(const Problem&)>& damaged,
                  const Limits& limits) {
    Merge(source, summary, selection, damaged, limits).run(visit, damaged);
}

}  // namespace oroforge::mcap
