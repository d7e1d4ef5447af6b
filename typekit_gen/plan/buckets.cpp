// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/buckets.hpp>

namespace oroforge::typekit {

std::uint64_t hashOf(const std::string& text) {
    // FNV-1a: std::hash may change with the standard library, and with it every generated file.
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211ULL;
    }
    return hash;
}

std::size_t bucketOf(const std::string& typeName) { return static_cast<std::size_t>(hashOf(typeName) % kBuckets); }

}  // namespace oroforge::typekit
