// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "crc32.hpp"

#include "format.hpp"

#include <array>

namespace oroforge::mcap {
namespace {

constexpr std::size_t kSlices = 16;
typedef std::array<std::array<std::uint32_t, 256>, kSlices> Tables;

/** The checksum of each byte, followed by as many zero bytes as the table has number. */
constexpr Tables makeTables() {
    Tables tables{};
    for (std::uint32_t byte = 0; byte != 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit != 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
        tables[0][byte] = crc;
    }
    for (std::size_t slice = 1; slice != kSlices; ++slice)
        for (std::size_t byte = 0; byte != 256; ++byte) {
            const std::uint32_t before = tables[slice - 1][byte];
            tables[slice][byte] = (before >> 8) ^ tables[0][before & 0xffU];
        }
    return tables;
}

constexpr Tables kTables = makeTables();

/** What four bytes contribute that `distance` bytes follow. */
inline std::uint32_t part(std::uint32_t word, std::size_t distance) {
    return kTables[distance + 3][word & 0xffU] ^ kTables[distance + 2][(word >> 8) & 0xffU] ^
           kTables[distance + 1][(word >> 16) & 0xffU] ^ kTables[distance][word >> 24];
}

}  // namespace

std::uint32_t crc32(const void* data, std::size_t size, std::uint32_t before) {
    const auto* at = static_cast<const unsigned char*>(data);
    std::uint32_t crc = ~before;
    for (; size >= kSlices; size -= kSlices, at += kSlices)
        crc = part(crc ^ numberAt<std::uint32_t>(at), 12) ^ part(numberAt<std::uint32_t>(at + 4), 8) ^
              part(numberAt<std::uint32_t>(at + 8), 4) ^ part(numberAt<std::uint32_t>(at + 12), 0);
    for (; size != 0; --size) crc = (crc >> 8) ^ kTables[0][(crc ^ *at++) & 0xffU];
    return ~crc;
}

}  // namespace oroforge::mcap
