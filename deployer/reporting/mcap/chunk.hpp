// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_CHUNK_HPP
#define OROFORGE_MCAP_CHUNK_HPP

#include "compression.hpp"
#include "records.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace oroforge::mcap {

/**
 * Messages that become one chunk of a file. All memory is taken by the constructor and by grow(), so that adding a
 * message neither allocates nor waits. Used by one thread at a time.
 */
class Chunk {
public:
    /** Where the messages of a channel are. */
    struct Entry {
        std::uint16_t channel;
        std::uint64_t time, offset;
    };

    /** @param room bytes for messages, their heads of kMessageHead included. Allocates. */
    explicit Chunk(std::size_t room);
    Chunk(const Chunk&) = delete;
    Chunk& operator=(const Chunk&) = delete;

    /** Where that many bytes of a message are to be written, before add(); null if there is no room for them. */
    unsigned char* place(std::size_t size);
    /** The number of bytes that place() has room for; 0 also if there is none for a message without data. */
    std::size_t left() const { return room_ - size_ < kMessageHead ? 0 : room_ - size_ - kMessageHead; }
    /** Adds the message whose data have been written there. Its `data` is ignored. */
    void add(const Message& message);

    /** Makes room for a message of that size in an empty chunk. Allocates. */
    void grow(std::size_t size);
    void clear();

    bool empty() const { return entries_.empty(); }
    const unsigned char* data() const { return bytes_.get(); }
    std::size_t size() const { return size_; }
    std::size_t room() const { return room_; }
    std::uint64_t start() const { return start_; }
    std::uint64_t end() const { return end_; }
    const std::vector<Entry>& entries() const { return entries_; }

private:
    void allocate(std::size_t room);

    std::unique_ptr<unsigned char[]> bytes_;
    std::size_t room_ = 0, size_ = 0;
    std::uint64_t start_ = 0, end_ = 0;
    std::vector<Entry> entries_;
};

/** A chunk as it goes to a file, with the index of its messages. Its memory is kept from one chunk to the next. */
struct PackedChunk {
    ChunkHead head;
    Bytes before;                         ///< the record up to the packed bytes
    const unsigned char* body = nullptr;  ///< head.packedSize bytes: in `packed`, or those of an uncompressed Chunk
    Bytes packed;
    Bytes after;  ///< MessageIndex records
    /** Of each channel: how many messages, and where in `after` its index begins. */
    struct Of {
        std::uint16_t channel;
        std::uint64_t messages, index;
    };
    std::vector<Of> channels;

    std::uint64_t length() const { return before.size() + head.packedSize; }

    /** Packs a chunk. Without a compressor the chunk must stay as it is while this is used. False, with a reason, if
        the compressor fails. */
    bool pack(const Chunk& chunk, Compressor* compressor, std::string& why);
    /** Copies what `body` points to, so that the chunk may be cleared. */
    void own();
};

/** Writes the MessageIndex records of these messages to `packed`. */
void indexMessages(const std::vector<Chunk::Entry>& entries, PackedChunk& packed);

}  // namespace oroforge::mcap

#endif
