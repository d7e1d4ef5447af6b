// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "chunk.hpp"

#include "crc32.hpp"

#include <algorithm>

namespace oroforge::mcap {
namespace {

/** A time and an offset in the index of a channel. */
constexpr std::size_t kIndexEntry = 16;

}  // namespace

Chunk::Chunk(std::size_t room) { allocate(std::max(room, kMessageHead)); }

void Chunk::allocate(std::size_t room) {
    entries_.reserve(room / kMessageHead);
    bytes_.reset(new unsigned char[room]);  // without setting them to zero
    room_ = room;
}

unsigned char* Chunk::place(std::size_t size) {
    const std::size_t left = room_ - size_;
    return left < kMessageHead || size > left - kMessageHead ? nullptr : &bytes_[size_ + kMessageHead];
}

void Chunk::add(const Message& message) {
    unsigned char* const at = &bytes_[size_];
    at[0] = static_cast<unsigned char>(Op::Message);
    putNumber<std::uint64_t>(at + 1, kMessageHead - kRecordHead + message.size);
    putNumber(at + 9, message.channel);
    putNumber(at + 11, message.sequence);
    putNumber(at + 15, message.logTime);
    putNumber(at + 23, message.publishTime);
    start_ = entries_.empty() ? message.logTime : std::min(start_, message.logTime);
    end_ = entries_.empty() ? message.logTime : std::max(end_, message.logTime);
    entries_.push_back({message.channel, message.logTime, size_});
    size_ += kMessageHead + message.size;
}

void Chunk::grow(std::size_t size) {
    if (size_ == 0 && room_ - kMessageHead < size) allocate(size + kMessageHead);
}

void Chunk::clear() {
    size_ = 0;
    entries_.clear();
}

void indexMessages(const std::vector<Chunk::Entry>& entries, PackedChunk& packed) {
    std::uint16_t most = 0;
    for (const Chunk::Entry& entry : entries) most = std::max(most, entry.channel);
    std::vector<std::size_t> at(std::size_t(most) + 1);
    for (const Chunk::Entry& entry : entries) ++at[entry.channel];
    packed.channels.clear();
    packed.after.clear();
    for (std::size_t channel = 0; channel != at.size(); ++channel) {
        const std::size_t count = at[channel];
        if (count == 0) continue;
        const auto id = static_cast<std::uint16_t>(channel);
        packed.channels.push_back({id, count, packed.after.size()});
        RecordPut record(packed.after, Op::MessageIndex);
        record.number(id).number(static_cast<std::uint32_t>(count * kIndexEntry)).end(count * kIndexEntry);
        at[channel] = packed.after.size();
        packed.after.resize(packed.after.size() + count * kIndexEntry);
    }
    for (const Chunk::Entry& entry : entries) {
        std::size_t& next = at[entry.channel];
        putNumber(&packed.after[next], entry.time);
        putNumber(&packed.after[next + 8], entry.offset);
        next += kIndexEntry;
    }
}

bool PackedChunk::pack(const Chunk& chunk, Compressor* compressor, std::string& why) {
    head.start = chunk.empty() ? 0 : chunk.start();
    head.end = chunk.empty() ? 0 : chunk.end();
    head.size = chunk.size();
    head.crc = crc32(chunk.data(), chunk.size());
    head.compression = nameOf(compressor ? compressor->compression() : Compression::None);
    head.packedSize = chunk.size();
    body = chunk.data();
    if (compressor) {
        head.packedSize = compressor->compress(chunk.data(), chunk.size(), packed, why);
        if (head.packedSize == 0) return false;
        body = packed.data();
    }
    before.clear();
    put(before, head);
    indexMessages(chunk.entries(), *this);
    return true;
}

void PackedChunk::own() {
    if (body == packed.data()) {
        packed.resize(head.packedSize);
        packed.shrink_to_fit();
    } else {
        packed.assign(body, body + head.packedSize);
    }
    body = packed.data();
}

}  // namespace oroforge::mcap
