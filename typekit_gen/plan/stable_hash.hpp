// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A hash that every machine computes alike.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_STABLE_HASH_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_STABLE_HASH_HPP

#include <cstdint>
#include <string>

namespace oroforge::typekit {

/// FNV-1a: std::hash may change with the standard library, and every generated file would change with it.
inline std::uint64_t hashOf(const std::string& text) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211ULL;
    }
    return hash;
}

}  // namespace oroforge::typekit

#endif
