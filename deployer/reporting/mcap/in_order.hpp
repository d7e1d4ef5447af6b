// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_IN_ORDER_HPP
#define OROFORGE_MCAP_IN_ORDER_HPP

#include "problem.hpp"
#include "records.hpp"
#include "scan.hpp"
#include "source.hpp"
#include "summary.hpp"
#include "unindexed.hpp"

#include <cstdint>
#include <functional>
#include <list>
#include <set>
#include <vector>

namespace oroforge::mcap {

/** Bytes of a file with messages: a chunk, or records one after another that are in none. */
struct Piece {
    std::uint64_t offset = 0, length = 0;
    std::uint64_t start = 0, end = 0;  ///< the earliest and the latest logTime
    std::set<std::uint16_t> channels;  ///< of its messages; any if it is empty
    bool isChunk = true;

    /** Adds the record of a message that is in no chunk. False if it does not follow the one before, or makes the piece
        too large. */
    bool addLoose(std::uint64_t time, std::uint64_t at, std::uint64_t size);
};

/** The chunks that an index names, each once, and then what it does not name. */
std::vector<Piece> piecesOf(const Summary& summary, const Unindexed& more);

/**
 * Gives messages in the order of their times, those of one time in the order of the file. Reads only the pieces that
 * contain such channels and times, and keeps in memory those that overlap. Damaged chunks are given to `damaged` and
 * left out. If a piece has messages that are earlier than it says, these come as soon as it is read.
 *
 * Used by one thread at a time. The source must outlive this.
 */
class InOrder {
public:
    typedef std::function<void(const Problem&)> Damaged;

    InOrder(Source& source, const std::vector<Piece>& pieces, ChannelIds known, Selection selection, Damaged damaged,
            const Limits& limits = {});
    ~InOrder();

    /** Null at the end. Valid until the next call. Reads the file and allocates. */
    const Message* next();

private:
    /** A piece in memory, and its messages that are still to come. */
    struct Open;
    bool isWanted(const Piece& piece) const;
    Open* earliest();
    void open(const Piece& piece);
    bool read(const Piece& piece, Open& one);

    Source& source_;
    ChannelIds known_;
    const Selection selection_;
    const Damaged damaged_;
    const Limits limits_;
    std::vector<Piece> waiting_;
    std::size_t next_ = 0;
    std::list<Open> open_;
    Open* given_ = nullptr;  // the piece of the message that was given last
};

}  // namespace oroforge::mcap

#endif
