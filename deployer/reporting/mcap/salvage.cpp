// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "salvage.hpp"

#include "compression.hpp"
#include "scan.hpp"
#include "summary.hpp"

#include <cstring>
#include <set>
#include <utility>

namespace oroforge::mcap {
namespace {

constexpr std::size_t kMostProblems = 1000;
/** Of messages that were not in a chunk. */
constexpr std::size_t kChunkRoom = std::size_t(1) << 20;

class Copy : public Visitor {
public:
    /** If the summary has a checksum, its descriptions are right; those in front of the chunks may have changed. */
    Copy(Sink& to, Salvaged& result, const Summary& summary)
        : writer_(to),
          result_(result),
          summary_(summary),
          isDescribed_(summary.hasChecksum && summary.describesAll()),
          loose_(kChunkRoom) {}

    void header(const Header& header) override { begin(header); }
    void schema(const Schema& schema) override {
        begin();
        if (!isDescribed_) add(schema);
    }
    void channel(const Channel& channel) override {
        begin();
        if (!isDescribed_) add(channel);
    }
    void metadata(const Metadata& metadata) override {
        begin();
        flush();
        (void)writer_.add(metadata);
    }
    void problem(const Problem& problem) override {
        if (result_.problems.size() < kMostProblems) result_.problems.push_back(problem);
        isSpoiled_ = isSpoiled_ || inChunk_;
    }
    void chunk(const ChunkHead& head, const Bytes& record, std::uint64_t) override {
        flush();
        inChunk_ = true;
        packed_.head = head;
        packed_.before.clear();
        put(packed_.before, head);
        // Bytes may follow the packed ones.
        Cursor content(record.data(), record.size());
        ChunkHead again;
        (void)getHead(content, again);
        const unsigned char* const packed = content.take(head.packedSize);
        packed_.packed.assign(packed, packed + head.packedSize);
        packed_.body = packed_.packed.data();
    }
    void chunkEnd() override {
        inChunk_ = false;
        if (std::exchange(isSpoiled_, false)) {
            addMessages();
        } else {
            indexMessages(entries_, packed_);
            write();
        }
        entries_.clear();
    }
    void message(const Message& message) override {
        ++result_.messages;
        if (inChunk_) return entries_.push_back({message.channel, message.logTime, message.offset});
        addLoose(message);
    }

    void end() {
        flush();
        begin();
        (void)writer_.finish();
        result_.error = writer_.error();
    }

private:
    /** Gives the messages of a chunk on, without those that are not described. */
    class Described : public Visitor {
    public:
        explicit Described(Copy& to) : to_(to) {}
        void message(const Message& message) override { to_.addLoose(message); }

    private:
        Copy& to_;
    };

    /** The chunk has records that are damaged, so it is not copied as it is. */
    void addMessages() {
        Bytes records;
        std::string why;
        if (!decompress(packed_.head.compression, packed_.packed.data(), packed_.packed.size(), packed_.head.size,
                        records, why))
            return;
        ChunkReader chunk;
        chunk.take(std::move(records));
        Described described(*this);
        visitRecords(chunk, 0, channels_, described);
        flush();
    }

    void begin(const Header& header = {"", "oroforge"}) {
        if (std::exchange(begun_, true)) return;
        (void)writer_.begin(header);
        if (!isDescribed_) return;
        for (const auto& [id, schema] : summary_.schemas) add(schema);
        for (const auto& [id, channel] : summary_.channels) add(channel);
    }
    void add(const Schema& schema) {
        if (schemas_.insert(schema.id).second) (void)writer_.add(schema);
    }
    void add(const Channel& channel) {
        if (channels_.insert(channel.id)) (void)writer_.add(channel);
    }
    void addLoose(const Message& message) {
        unsigned char* place = loose_.place(message.size);
        if (!place) {
            flush();
            loose_.grow(message.size);
            place = loose_.place(message.size);
        }
        if (message.size != 0) std::memcpy(place, message.data, message.size);
        loose_.add(message);
    }
    void flush() {
        if (loose_.empty()) return;
        std::string why;
        (void)packed_.pack(loose_, nullptr, why);
        write();
        loose_.clear();
    }
    void write() {
        begin();
        if (writer_.write(packed_)) ++result_.chunks;
    }

    Writer writer_;
    Salvaged& result_;
    const Summary& summary_;
    const bool isDescribed_;
    Chunk loose_;
    PackedChunk packed_;
    bool begun_ = false, inChunk_ = false, isSpoiled_ = false;
    std::vector<Chunk::Entry> entries_;
    std::set<std::uint16_t> schemas_;
    ChannelIds channels_;
};

}  // namespace

Salvaged salvage(Source& from, Sink& to) {
    Salvaged result;
    Summary summary;
    if (readSummary(from, summary)) summary = {};
    Copy copy(to, result, summary);
    (void)scan(from, copy);
    copy.end();
    return result;
}

}  // namespace oroforge::mcap
