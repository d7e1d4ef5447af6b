// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_SPLIT_HPP
#define OROFORGE_RECORDING_SPLIT_HPP

#include <cstdint>
#include <string>

namespace OCL::recording {

/** When a file ends and the next one begins; 0: never. */
struct Split {
    std::uint64_t bytes = 0, nanoseconds = 0;
};

/** False if the number is not positive, or more than ten years, with which nothing overflows. */
inline bool isTime(double seconds) { return seconds > 0 && seconds <= 3.2e8; }

/** "", "500 MB", "2GB", "90 s", "10 min". */
bool readSplit(const std::string& text, Split& split);
bool readSize(const std::string& text, std::uint64_t& bytes);

}  // namespace OCL::recording

#endif
