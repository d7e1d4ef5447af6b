// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_SUMMARY_HPP
#define OROFORGE_MCAP_SUMMARY_HPP

#include "problem.hpp"
#include "records.hpp"
#include "scan.hpp"
#include "source.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace oroforge::mcap {

/** What the end of a file says of it. */
struct Summary {
    std::map<std::uint16_t, Schema> schemas;
    std::map<std::uint16_t, Channel> channels;
    std::vector<ChunkIndex> chunks;  ///< in the order of the file
    std::vector<MetadataIndex> metadata;
    Statistics statistics;
    bool hasChecksum = false;  ///< and it is right

    /** False if channels or schemas are described in front of it only: an index need not repeat them. */
    bool describesAll() const;
};

/** A problem if the file has no end, or what it says is damaged; scan() reads such a file. A file may have an end that
    says nothing. */
Problem readSummary(Source& source, Summary& summary, const Limits& limits = {});

/** The messages to read: those with start <= logTime < end. */
struct Selection {
    std::uint64_t start = 0, end = ~std::uint64_t(0);
    std::set<std::uint16_t> channels;  ///< all if it is empty
};

/**
 * Visits messages in the order of their times, those of one time in the order of the file. Reads only the chunks that
 * contain such channels and times, and keeps in memory those that overlap. What the summary does not name is looked
 * for. Damaged chunks are given to `damaged` and left out.
 */
void readMessages(Source& source, const Summary& summary, const Selection& selection,
                  const std::function<void(const Message&)>& visit, const std::function<void(const Problem&)>& damaged,
                  const Limits& limits = {});

}  // namespace oroforge::mcap

#endif
