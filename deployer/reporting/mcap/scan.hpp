// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_SCAN_HPP
#define OROFORGE_MCAP_SCAN_HPP

#include "problem.hpp"
#include "records.hpp"
#include "source.hpp"

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace oroforge::mcap {

/** Receives what a file contains, in the order of the file. Data are valid during the call. */
class Visitor {
public:
    virtual ~Visitor() = default;
    virtual void header(const Header&) {}
    virtual void schema(const Schema&) {}
    virtual void channel(const Channel&) {}
    /** A chunk, before what is in it, whose checksum is right. `record` is the content of the chunk's record, which
        begins at `offset`. */
    virtual void chunk(const ChunkHead&, const Bytes& record, std::uint64_t offset) { (void)record, (void)offset; }
    /** The end of what is in it. Messages may also come outside chunks. */
    virtual void chunkEnd() {}
    virtual void message(const Message&) {}
    virtual void metadata(const Metadata&) {}
    /** What is damaged has been left out. */
    virtual void problem(const Problem&) {}
};

/** Limits on what damaged or hostile files make a reader do. */
struct Limits {
    std::uint64_t largestRecord = std::uint64_t(1) << 32;
    std::uint64_t largestChunk = std::uint64_t(1) << 32;  ///< when it is no longer compressed
};

struct Scanned {
    bool hasEnd = false;      ///< there was a DataEnd record: the writer has finished
    std::uint64_t whole = 0;  ///< the end of the last whole record
    std::uint64_t problems = 0;
};

/**
 * Reads a file from its beginning, also one without its end. Damaged records are reported and left out. If the place of
 * the next record is unknown, it goes on with the next chunk that the file's index names. A schema or channel whose
 * record is damaged is taken from the index.
 *
 * Every length is compared with the bytes that are left before memory is taken.
 */
Scanned scan(Source& source, Visitor& visitor, const Limits& limits = {});

/** Numbers of channels. */
class ChannelIds {
public:
    bool has(std::uint16_t id) const { return ids_.test(id); }
    /** True if it was not there. */
    bool insert(std::uint16_t id) {
        const bool isNew = !has(id);
        ids_.set(id);
        return isNew;
    }
    void insertAll() { ids_.set(); }
    /** A channel that is not known is one problem of a chunk, however many messages belong to it. */
    void beginChunk() { reported_.reset(); }
    bool report(std::uint16_t id) {
        const bool isNew = !reported_.test(id);
        reported_.set(id);
        return isNew;
    }

private:
    std::bitset<std::size_t(1) << 16> ids_, reported_;
};

/** What scan() does with the records of one chunk; `content` is that of its record, which begins at `offset`. */
class ChunkReader {
public:
    /** A problem if the chunk is damaged. */
    Problem open(const Bytes& content, std::uint64_t offset, const Limits& limits);
    /** Records that are in no chunk. */
    void take(Bytes records) { records_ = std::move(records); }
    const ChunkHead& head() const { return head_; }
    /** The records. */
    const Bytes& records() const { return records_; }

private:
    ChunkHead head_;
    Bytes records_;
};

/** Adds channels that are described elsewhere to those that are known. */
using FindChannels = std::function<void()>;

/** Visits the records of a chunk. Messages whose channels are not among `known`, also after `find`, are problems. */
void visitRecords(const ChunkReader& chunk, std::uint64_t offset, ChannelIds& known, Visitor& visitor,
                  const FindChannels& find = {});

}  // namespace oroforge::mcap

#endif
