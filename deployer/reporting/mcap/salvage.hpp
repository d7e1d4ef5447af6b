// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_SALVAGE_HPP
#define OROFORGE_MCAP_SALVAGE_HPP

#include "problem.hpp"
#include "source.hpp"
#include "writer.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace oroforge::mcap {

struct Salvaged {
    std::uint64_t messages = 0, chunks = 0;
    std::vector<Problem> problems;  ///< the first thousand
    std::string error;              ///< why the new file could not be written; empty if all is well
};

/**
 * Writes what is whole of a file to a new one, which has an index. Whole chunks are copied as they are. Schemas and
 * channels that are in chunks are written in front of them, too.
 */
Salvaged salvage(Source& from, Sink& to);

}  // namespace oroforge::mcap

#endif
