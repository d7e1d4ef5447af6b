// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_UNINDEXED_HPP
#define OROFORGE_MCAP_UNINDEXED_HPP

#include "problem.hpp"
#include "records.hpp"
#include "source.hpp"
#include "summary.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace oroforge::mcap {

/** Where a message is that is in no chunk: its record begins there, and has so many bytes behind its head. */
struct LooseMessage {
    std::uint64_t time, offset, size;
};

/** What a file has that its index does not name. An index need not name all, or any, of its chunks. */
struct Unindexed {
    std::vector<ChunkIndex> chunks;
    std::vector<LooseMessage> messages;  ///< in the order of the file
    ChannelIds channels;                 ///< of records that are in no chunk
};

/** Goes from record to record, and from each chunk that the index names to what is behind it. Keeps of the messages
    those of the selection. What is damaged is given to `damaged`. */
Unindexed findUnindexed(Source& source, const Summary& summary, const Selection& selection,
                        const std::function<void(const Problem&)>& damaged);

}  // namespace oroforge::mcap

#endif
