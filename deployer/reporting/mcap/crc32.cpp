// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "crc32.hpp"

#include "format.hpp"

#include <array>

namespace oroforge::mcap {
namespace {

constexpr std::uint32_t kPolynomial = 0xedb88320U;
constexpr std::size_t kSlices = 16;
typedef std::array<std::array<std::uint32_t, 256>, kSlices> Tables;

/** The checksum of each byte, followed by as many zero bytes as the table has number. */
constexpr Tables makeTables() {
    Tables tables{};
    for (std::uint32_t byte = 0; byte != 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit != 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? kPolynomial : 0U);
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

/** The product of two polynomials modulo that of the checksum. The highest bit is the coefficient of x⁰. */
std::uint32_t product(std::uint32_t one, std::uint32_t other) {
    std::uint32_t sum = 0;
    for (; one != 0; one <<= 1) {
        if ((one & 0x80000000U) != 0) sum ^= other;
        other = (other >> 1) ^ ((other & 1U) != 0 ? kPolynomial : 0U);
    }
    return sum;
}

}  // namespace

std::uint32_t crc32Joined(std::uint32_t first, std::uint32_t second, std::uint64_t sizeOfSecond) {
    // Each byte that follows multiplies the first checksum by x⁸.
    for (std::uint32_t power = 0x00800000U; sizeOfSecond != 0; sizeOfSecond >>= 1, power = product(power, power))
        if ((sizeOfSecond & 1U) != 0) first = product(first, power);
    return first ^ second;
}

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
