// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_PROBLEM_HPP
#define OROFORGE_MCAP_PROBLEM_HPP

#include <cstdint>
#include <string>

namespace oroforge::mcap {

/** What is wrong with a file, and where. */
struct Problem {
    const char* code = nullptr;  ///< such as "MCP003"; null if nothing is wrong
    std::uint64_t offset = 0;    ///< of the byte at which the damaged record begins
    std::string text;            ///< without a capital and a full stop

    explicit operator bool() const { return code != nullptr; }
    /** "run.mcap: byte 4711: error: [MCP003] the checksum of the chunk is wrong" */
    std::string line(const std::string& file) const {
        return file + ": byte " + std::to_string(offset) + ": error: [" + code + "] " + text;
    }
};

}  // namespace oroforge::mcap

#endif
