// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_PIECES_HPP
#define OROFORGE_MCAP_PIECES_HPP

#include "problem.hpp"
#include "scan.hpp"
#include "source.hpp"
#include "summary.hpp"

#include <cstdint>
#include <functional>
#include <set>
#include <vector>

namespace oroforge::mcap {

/** Bytes of a file with messages: a chunk, or records one after another that are in none. */
struct Piece {
    std::uint64_t offset = 0, length = 0;
    std::uint64_t start = 0, end = 0;  ///< the earliest and the latest logTime
    std::set<std::uint16_t> channels;  ///< of its messages; any if it is empty
    bool isChunk = true;
};

/** Where the messages of a file are. */
struct Pieces {
    std::vector<Piece> all;
    ChannelIds channels;  ///< those that are known to be described

    /** Adds a record with a message that is in no chunk; messages behind each other become one piece. */
    void addLoose(std::uint64_t offset, std::uint64_t length, std::uint64_t time, std::uint16_t channel);
};

/** The chunks that an index names, each once. */
std::vector<Piece> namedPieces(const Summary& summary);

/** What the index names, and what it does not: it need not name all chunks, or any. Goes from record to record, and
    from each chunk that the index names to what is behind it. What is damaged is given to `damaged`. */
Pieces findPieces(Source& source, const Summary& summary, const std::function<void(const Problem&)>& damaged);

}  // namespace oroforge::mcap

#endif
