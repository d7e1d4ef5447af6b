// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which source file a type goes into.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_BUCKETS_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_BUCKETS_HPP

#include <cstddef>
#include <cstdint>
#include <string>

namespace oroforge::typekit {

/// Types are spread over this many source files by a hash of their names: a new type changes one of them. So many that the
/// compiler needs no gigabyte for a file of a typekit with some hundred types.
constexpr std::size_t kBuckets = 16;

/// The same everywhere and for ever.
std::uint64_t hashOf(const std::string& text);

std::size_t bucketOf(const std::string& typeName);

}  // namespace oroforge::typekit

#endif
