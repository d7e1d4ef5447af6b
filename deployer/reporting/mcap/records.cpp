// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "records.hpp"

namespace oroforge::mcap {
namespace {

typedef std::map<std::uint16_t, std::uint64_t> Numbers;

void putNumbers(RecordPut& record, const Numbers& numbers) {
    record.number(static_cast<std::uint32_t>(numbers.size() * 10));
    for (const auto& [id, number] : numbers) record.number(id).number(number);
}

Numbers numbersOf(Cursor& content) {
    Numbers numbers;
    Cursor all = content.part(content.number<std::uint32_t>());
    while (all.left() >= 10) {
        const auto id = all.number<std::uint16_t>();
        numbers[id] = all.number<std::uint64_t>();
    }
    return numbers;
}

}  // namespace

void put(Bytes& out, const Header& header) {
    RecordPut(out, Op::Header).text(header.profile).text(header.library).end();
}

void put(Bytes& out, const Schema& schema) {
    RecordPut(out, Op::Schema).number(schema.id).text(schema.name).text(schema.encoding).text(schema.data).end();
}

void put(Bytes& out, const Channel& channel) {
    RecordPut record(out, Op::Channel);
    record.number(channel.id).number(channel.schema).text(channel.topic).text(channel.encoding);
    record.texts(channel.metadata).end();
}

void put(Bytes& out, const Metadata& metadata) {
    RecordPut(out, Op::Metadata).text(metadata.name).texts(metadata.texts).end();
}

void put(Bytes& out, const ChunkHead& chunk) {
    RecordPut record(out, Op::Chunk);
    record.number(chunk.start).number(chunk.end).number(chunk.size).number(chunk.crc);
    record.text(chunk.compression).number(chunk.packedSize).end(chunk.packedSize);
}

void put(Bytes& out, const ChunkIndex& index) {
    RecordPut record(out, Op::ChunkIndex);
    record.number(index.head.start).number(index.head.end).number(index.offset).number(index.length);
    putNumbers(record, index.channels);
    record.number(index.indexLength).text(index.head.compression);
    record.number(index.head.packedSize).number(index.head.size).end();
}

void put(Bytes& out, const MetadataIndex& index) {
    RecordPut(out, Op::MetadataIndex).number(index.offset).number(index.length).text(index.name).end();
}

void put(Bytes& out, const Statistics& statistics) {
    RecordPut record(out, Op::Statistics);
    record.number(statistics.messages).number(statistics.schemas).number(statistics.channels);
    record.number(statistics.attachments).number(statistics.metadata).number(statistics.chunks);
    record.number(statistics.start).number(statistics.end);
    putNumbers(record, statistics.ofChannel);
    record.end();
}

bool get(Cursor content, Header& header) {
    header.profile = content.text();
    header.library = content.text();
    return content.good();
}

bool get(Cursor content, Schema& schema) {
    schema.id = content.number<std::uint16_t>();
    schema.name = content.text();
    schema.encoding = content.text();
    schema.data = content.text();
    return content.good();
}

bool get(Cursor content, Channel& channel) {
    channel.id = content.number<std::uint16_t>();
    channel.schema = content.number<std::uint16_t>();
    channel.topic = content.text();
    channel.encoding = content.text();
    channel.metadata = content.texts();
    return content.good();
}

bool get(Cursor content, Message& message) {
    message.channel = content.number<std::uint16_t>();
    message.sequence = content.number<std::uint32_t>();
    message.logTime = content.number<std::uint64_t>();
    message.publishTime = content.number<std::uint64_t>();
    message.size = content.left();
    message.data = content.take(message.size);
    return content.good();
}

bool get(Cursor content, Metadata& metadata) {
    metadata.name = content.text();
    metadata.texts = content.texts();
    return content.good();
}

bool getHead(Cursor& content, ChunkHead& chunk) {
    chunk.start = content.number<std::uint64_t>();
    chunk.end = content.number<std::uint64_t>();
    chunk.size = content.number<std::uint64_t>();
    chunk.crc = content.number<std::uint32_t>();
    chunk.compression = content.text();
    chunk.packedSize = content.number<std::uint64_t>();
    return content.good();
}

bool get(Cursor content, ChunkIndex& index) {
    index.head.start = content.number<std::uint64_t>();
    index.head.end = content.number<std::uint64_t>();
    index.offset = content.number<std::uint64_t>();
    index.length = content.number<std::uint64_t>();
    index.channels = numbersOf(content);
    index.indexLength = content.number<std::uint64_t>();
    index.head.compression = content.text();
    index.head.packedSize = content.number<std::uint64_t>();
    index.head.size = content.number<std::uint64_t>();
    return content.good();
}

bool get(Cursor content, MetadataIndex& index) {
    index.offset = content.number<std::uint64_t>();
    index.length = content.number<std::uint64_t>();
    index.name = content.text();
    return content.good();
}

bool get(Cursor content, Statistics& statistics) {
    statistics.messages = content.number<std::uint64_t>();
    statistics.schemas = content.number<std::uint16_t>();
    statistics.channels = content.number<std::uint32_t>();
    statistics.attachments = content.number<std::uint32_t>();
    statistics.metadata = content.number<std::uint32_t>();
    statistics.chunks = content.number<std::uint32_t>();
    statistics.start = content.number<std::uint64_t>();
    statistics.end = content.number<std::uint64_t>();
    statistics.ofChannel = numbersOf(content);
    return content.good();
}

}  // namespace oroforge::mcap
