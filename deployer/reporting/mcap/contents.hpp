// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_CONTENTS_HPP
#define OROFORGE_MCAP_CONTENTS_HPP

#include "in_order.hpp"
#include "problem.hpp"
#include "records.hpp"
#include "scan.hpp"
#include "source.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace oroforge::mcap {

/** What is in a file, and where. */
struct Contents {
    std::map<std::uint16_t, Schema> schemas;
    std::map<std::uint16_t, Channel> channels;
    std::vector<Piece> pieces;  ///< in the order of the file
    std::vector<Metadata> metadata;
    std::map<std::uint16_t, std::uint64_t> counts;  ///< of the messages of channels
    std::uint64_t start = 0, end = 0;               ///< the times of the first and the last message
    bool hasIndex = false;                          ///< it was read from the index at the end of the file

    ChannelIds ids() const {
        ChannelIds all;
        for (const auto& [id, channel] : channels) (void)all.insert(id);
        return all;
    }
};

/**
 * Reads the index of a file. If there is none, or it is damaged, the file is read from its beginning, one record at a
 * time, and all that is kept is where the chunks are. What is damaged is given to `report` and left out.
 */
Contents readContents(Source& source, const std::function<void(const Problem&)>& report);

}  // namespace oroforge::mcap

#endif
