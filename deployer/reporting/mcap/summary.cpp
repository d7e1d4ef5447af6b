// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "summary.hpp"

#include "crc32.hpp"

#include <algorithm>

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

bool Summary::describesAll() const {
    const auto isDescribed = [this](const auto& one) {
        return one.second.schema == 0 || schemas.count(one.second.schema) != 0;
    };
    return !channels.empty() && channels.size() >= statistics.channels &&
           std::all_of(channels.begin(), channels.end(), isDescribed);
}

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
    if (begin == 0) return {};  // the file has none
    if (begin < sizeof kMagic || begin > footer)
        return damaged(footer, "it would begin at byte " + std::to_string(begin));
    if (footer - begin > limits.largestRecord) return damaged(begin, "it is larger than this reader takes");
    Bytes bytes(static_cast<std::size_t>(footer - begin));
    if (!source.read(begin, bytes.data(), bytes.size())) return {"MCP010", begin, "the file cannot be read here"};
    const auto crc = numberAt<std::uint32_t>(end + kFooter - 4);
    if (crc != 0 && crc32(end, kFooter - 4, crc32(bytes.data(), bytes.size())) != crc)
        return damaged(begin, "its checksum is wrong");
    summary.hasChecksum = crc != 0;
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

}  // namespace oroforge::mcap
