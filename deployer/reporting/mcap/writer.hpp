// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_WRITER_HPP
#define OROFORGE_MCAP_WRITER_HPP

#include "chunk.hpp"
#include "records.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace oroforge::mcap {

/** Where bytes of a file go. */
class Sink {
public:
    struct Piece {
        const unsigned char* data;
        std::size_t size;
    };
    virtual ~Sink() = default;
    /** Writes all pieces one after another. Returns the reason of a failure, or nothing. */
    virtual std::string write(const Piece* pieces, std::size_t count) = 0;
};

/** Collects a file in memory. */
class MemorySink : public Sink {
public:
    std::string write(const Piece* pieces, std::size_t count) override;
    Bytes bytes;
};

/**
 * Writes a file from its beginning to its end, without going back, so that a pipe will do. Each call writes whole
 * records; a file that ends after any of them can be scanned. Used by one thread at a time.
 *
 * After an error nothing more is written, and all functions return false.
 */
class Writer {
public:
    /** `sink` must outlive this. */
    explicit Writer(Sink& sink) : sink_(sink) {}

    bool begin(const Header& header);
    /** In front of the messages to which it belongs. */
    bool add(const Schema& schema);
    bool add(const Channel& channel);
    bool add(const Metadata& metadata);
    bool write(const PackedChunk& chunk);
    /** Writes indexes and statistics. */
    bool finish();

    /** The number of bytes that were written. */
    std::uint64_t offset() const { return offset_; }
    const Statistics& statistics() const { return statistics_; }
    /** Why nothing more is written; empty if all is well. */
    const std::string& error() const { return error_; }

private:
    bool write(const Sink::Piece* pieces, std::size_t count);
    bool writeRecord();
    template <class Write>
    void group(Op op, Write write);

    Sink& sink_;
    std::uint64_t offset_ = 0;
    Statistics statistics_;
    Bytes record_;
    Bytes schemas_, channels_;  // the records, which the summary repeats
    Bytes chunks_;              // ChunkIndex records: as bytes, because a long recording has many
    std::vector<MetadataIndex> metadata_;
    Bytes groups_;  // SummaryOffset records
    std::string error_;
};

}  // namespace oroforge::mcap

#endif
