// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_RECORDS_HPP
#define OROFORGE_MCAP_RECORDS_HPP

#include "format.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace oroforge::mcap {

struct Header {
    std::string profile, library;
};

/** How the messages of a channel are read. The id is not 0. */
struct Schema {
    std::uint16_t id = 0;
    std::string name, encoding, data;
};

struct Channel {
    std::uint16_t id = 0;
    std::uint16_t schema = 0;  ///< 0 if there is none
    std::string topic, encoding;
    Texts metadata;
};

/** Times are nanoseconds. */
struct Message {
    std::uint16_t channel = 0;
    std::uint32_t sequence = 0;
    std::uint64_t logTime = 0, publishTime = 0;
    const unsigned char* data = nullptr;
    std::size_t size = 0;
    std::uint64_t offset = 0;  ///< of its record: among those of its chunk, or in the file if it is in none
};

struct Metadata {
    std::string name;
    Texts texts;
};

/** What stands before the records of a chunk. */
struct ChunkHead {
    std::uint64_t start = 0, end = 0;  ///< the earliest and the latest logTime; 0 without messages
    std::uint64_t size = 0;            ///< of the records when they are not compressed
    std::uint32_t crc = 0;             ///< of those bytes; 0 if it is unknown
    std::string compression;
    std::uint64_t packedSize = 0;
};

struct ChunkIndex {
    ChunkHead head;
    std::uint64_t offset = 0, length = 0;             ///< of the chunk in the file, its kRecordHead included
    std::map<std::uint16_t, std::uint64_t> channels;  ///< where the index of the messages of each is
    std::uint64_t indexLength = 0;                    ///< of all those indexes
};

struct MetadataIndex {
    std::uint64_t offset = 0, length = 0;
    std::string name;
};

struct Statistics {
    std::uint64_t messages = 0;
    std::uint16_t schemas = 0;
    std::uint32_t channels = 0, attachments = 0, metadata = 0, chunks = 0;
    std::uint64_t start = 0, end = 0;
    std::map<std::uint16_t, std::uint64_t> ofChannel;  ///< messages
};

// Each adds one record.
void put(Bytes& out, const Header& header);
void put(Bytes& out, const Schema& schema);
void put(Bytes& out, const Channel& channel);
void put(Bytes& out, const Metadata& metadata);
void put(Bytes& out, const ChunkIndex& index);
void put(Bytes& out, const MetadataIndex& index);
void put(Bytes& out, const Statistics& statistics);
/** Without the packed bytes, which must follow. */
void put(Bytes& out, const ChunkHead& chunk);

// Each takes the content of one record; false if its lengths are larger than it.
bool get(Cursor content, Header& header);
bool get(Cursor content, Schema& schema);
bool get(Cursor content, Channel& channel);
bool get(Cursor content, Message& message);
bool get(Cursor content, Metadata& metadata);
bool get(Cursor content, ChunkIndex& index);
bool get(Cursor content, MetadataIndex& index);
bool get(Cursor content, Statistics& statistics);
/** Leaves `content` at the packed bytes. */
bool getHead(Cursor& content, ChunkHead& chunk);

}  // namespace oroforge::mcap

#endif
