// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "unindexed.hpp"

#include "format.hpp"

#include <algorithm>

namespace oroforge::mcap {
namespace {

class Walk {
public:
    Walk(Source& source, const Summary& summary, const Selection& selection,
         const std::function<void(const Problem&)>& damaged)
        : source_(source), chunks_(summary.chunks), selection_(selection), damaged_(damaged) {}

    Unindexed run() {
        at_ = sizeof kMagic;
        while (at_ < source_.size() && (passIndexed() || record())) {
        }
        return std::move(found_);
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
        if (op == Op::Message && length >= kMessage) add(content, length);
        if (op == Op::Chunk && length >= kTimes) {
            ChunkIndex chunk;
            chunk.offset = at_;
            chunk.length = kRecordHead + length;
            chunk.head.start = content.number<std::uint64_t>();
            chunk.head.end = content.number<std::uint64_t>();
            found_.chunks.push_back(chunk);
        }
        at_ += kRecordHead + length;
        return true;
    }

    void add(Cursor content, std::uint64_t length) {
        const auto channel = content.number<std::uint16_t>();
        (void)content.number<std::uint32_t>();  // the sequence number
        const auto time = content.number<std::uint64_t>();
        const bool isWanted = selection_.channels.empty() || selection_.channels.count(channel) != 0;
        if (isWanted && time >= selection_.start && time < selection_.end)
            found_.messages.push_back({time, at_, length});
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
    const Selection& selection_;
    const std::function<void(const Problem&)>& damaged_;
    Unindexed found_;
    std::uint64_t at_ = 0;
    std::size_t next_ = 0;  // among the chunks
};

}  // namespace

Unindexed findUnindexed(Source& source, const Summary& summary, const Selection& selection,
                        const std::function<void(const Problem&)>& damaged) {
    return Walk(source, summary, selection, damaged).run();
}

}  // namespace oroforge::mcap
