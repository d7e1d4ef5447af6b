// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/md5.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace oroforge::messages {

namespace {

using Words = std::array<std::uint32_t, 4>;

std::array<std::uint32_t, 64> sines() {
    std::array<std::uint32_t, 64> table = {};
    for (std::size_t i = 0; i != table.size(); ++i)
        table[i] =
            static_cast<std::uint32_t>(std::floor(std::fabs(std::sin(static_cast<double>(i + 1))) * 4294967296.0));
    return table;
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i != 4; ++i)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return word;
}

void add(const std::string& padded, std::size_t block, Words& sum) {
    static const std::array<std::uint32_t, 64> table = sines();
    static constexpr unsigned shifts[4][4] = {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}};
    auto [a, b, c, d] = sum;
    for (unsigned i = 0; i != 64; ++i) {
        std::uint32_t mixed = 0;
        unsigned word = 0;
        switch (i / 16) {
            case 0: mixed = (b & c) | (~b & d), word = i; break;
            case 1: mixed = (d & b) | (~d & c), word = (5 * i + 1) % 16; break;
            case 2: mixed = b ^ c ^ d, word = (3 * i + 5) % 16; break;
            default: mixed = c ^ (b | ~d), word = (7 * i) % 16; break;
        }
        mixed += a + table[i] + wordAt(padded, block + 4 * word);
        const unsigned shift = shifts[i / 16][i % 4];
        a = d, d = c, c = b;
        b += (mixed << shift) | (mixed >> (32 - shift));
    }
    sum = {sum[0] + a, sum[1] + b, sum[2] + c, sum[3] + d};
}

}  // namespace

std::string md5(const std::string& bytes) {
    std::string padded = bytes + '\x80';
    padded.resize((padded.size() + 8 + 63) / 64 * 64 - 8, '\0');
    for (unsigned i = 0; i != 8; ++i) padded += static_cast<char>((std::uint64_t(bytes.size()) * 8) >> (8 * i));
    Words sum = {0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
    for (std::size_t block = 0; block != padded.size(); block += 64) add(padded, block, sum);
    std::string digits;
    for (const std::uint32_t word : sum) {
        for (unsigned i = 0; i != 4; ++i) {
            char two[3];
            std::snprintf(two, sizeof two, "%02x", (word >> (8 * i)) & 0xff);
            digits += two;
        }
    }
    return digits;
}

}  // namespace oroforge::messages
