// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_CRC32_HPP
#define OROFORGE_MCAP_CRC32_HPP

#include <cstddef>
#include <cstdint>

namespace oroforge::mcap {

/** The checksum of zip and Ethernet. `before` is that of the bytes before these; 0 if there are none. */
std::uint32_t crc32(const void* data, std::size_t size, std::uint32_t before = 0);
/** The checksum of two blocks of bytes, one behind the other, from the checksums of both. */
std::uint32_t crc32Joined(std::uint32_t first, std::uint32_t second, std::uint64_t sizeOfSecond);

}  // namespace oroforge::mcap

#endif
