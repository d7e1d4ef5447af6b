// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "writer.hpp"

#include "crc32.hpp"

#include <algorithm>

namespace oroforge::mcap {

std::string MemorySink::write(const Piece* pieces, std::size_t count) {
    for (const Piece* piece = pieces; piece != pieces + count; ++piece)
        bytes.insert(bytes.end(), piece->data, piece->data + piece->size);
    return {};
}

bool Writer::write(const Sink::Piece* pieces, std::size_t count) {
    if (!error_.empty()) return false;
    error_ = sink_.write(pieces, count);
    if (!error_.empty()) return false;
    for (const Sink::Piece* piece = pieces; piece != pieces + count; ++piece) offset_ += piece->size;
    return true;
}

bool Writer::writeRecord() {
    const Sink::Piece piece = {record_.data(), record_.size()};
    return write(&piece, 1);
}

bool Writer::begin(const Header& header) {
    record_.assign(std::begin(kMagic), std::end(kMagic));
    put(record_, header);
    return writeRecord();
}

bool Writer::add(const Schema& schema) {
    record_.clear();
    put(record_, schema);
    if (!writeRecord()) return false;
    schemas_.insert(schemas_.end(), record_.begin(), record_.end());
    ++statistics_.schemas;
    return true;
}

bool Writer::add(const Channel& channel) {
    record_.clear();
    put(record_, channel);
    if (!writeRecord()) return false;
    channels_.insert(channels_.end(), record_.begin(), record_.end());
    ++statistics_.channels;
    return true;
}

bool Writer::add(const Metadata& metadata) {
    record_.clear();
    put(record_, metadata);
    const std::uint64_t begin = offset_;
    if (!writeRecord()) return false;
    metadata_.push_back({begin, record_.size(), metadata.name});
    ++statistics_.metadata;
    return true;
}

bool Writer::write(const PackedChunk& chunk) {
    ChunkIndex index;
    index.head = chunk.head;
    index.offset = offset_;
    index.length = chunk.length();
    index.indexLength = chunk.after.size();
    const std::uint64_t indexes = offset_ + index.length;
    for (const PackedChunk::Of& of : chunk.channels) index.channels[of.channel] = indexes + of.index;
    const Sink::Piece pieces[] = {{chunk.before.data(), chunk.before.size()},
                                  {chunk.body, static_cast<std::size_t>(chunk.head.packedSize)},
                                  {chunk.after.data(), chunk.after.size()}};
    if (!write(pieces, 3)) return false;
    put(chunks_, index);
    if (!chunk.channels.empty()) {
        statistics_.start =
            statistics_.messages == 0 ? chunk.head.start : std::min(statistics_.start, chunk.head.start);
        statistics_.end = std::max(statistics_.end, chunk.head.end);
    }
    for (const PackedChunk::Of& of : chunk.channels) {
        statistics_.messages += of.messages;
        statistics_.ofChannel[of.channel] += of.messages;
    }
    ++statistics_.chunks;
    return true;
}

/** A group of records of one kind in the summary, with where it is. */
template <class Write>
void Writer::group(Op op, Write write) {
    const std::size_t begin = record_.size();
    write();
    if (record_.size() == begin) return;
    RecordPut(groups_, Op::SummaryOffset)
        .number(static_cast<std::uint8_t>(op))
        .number(offset_ + begin)
        .number<std::uint64_t>(record_.size() - begin)
        .end();
}

bool Writer::finish() {
    record_.clear();
    RecordPut(record_, Op::DataEnd).number<std::uint32_t>(0).end();
    const std::size_t summary = record_.size();
    group(Op::Schema, [&] { record_.insert(record_.end(), schemas_.begin(), schemas_.end()); });
    group(Op::Channel, [&] { record_.insert(record_.end(), channels_.begin(), channels_.end()); });
    group(Op::Statistics, [&] { put(record_, statistics_); });
    group(Op::ChunkIndex, [&] { record_.insert(record_.end(), chunks_.begin(), chunks_.end()); });
    group(Op::MetadataIndex, [&] {
        for (const MetadataIndex& index : metadata_) put(record_, index);
    });
    const std::uint64_t groups = offset_ + record_.size();
    record_.insert(record_.end(), groups_.begin(), groups_.end());
    RecordPut footer(record_, Op::Footer);
    footer.number(offset_ + summary).number(groups).number<std::uint32_t>(0).end();
    const std::size_t crc = record_.size() - 4;
    putNumber(&record_[crc], crc32(&record_[summary], crc - summary));
    record_.insert(record_.end(), std::begin(kMagic), std::end(kMagic));
    return writeRecord();
}

}  // namespace oroforge::mcap
