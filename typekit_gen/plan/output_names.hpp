// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Names of the generated files: a function of the typekit's name alone, so that CMake can ask before anything is read.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_OUTPUT_NAMES_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_OUTPUT_NAMES_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace oroforge::typekit {

/// Types are spread over this many source files by a hash of their names: a new type changes one of them. So many that the
/// compiler needs no gigabyte for a file of a typekit with some hundred types.
constexpr std::size_t kBuckets = 16;

/// The same everywhere and for ever.
std::uint64_t hashOf(const std::string& text);

std::size_t bucketOf(const std::string& typeName);

std::string userHeaderName(const std::string& typekit);  ///< "types/NAME/typekit/Types.hpp"
std::string bucketFileName(std::size_t bucket);          ///< "types_0.cpp"
std::string pluginFileName();                            ///< "Plugin.cpp"

std::vector<std::string> outputNames(const std::string& typekit);

}  // namespace oroforge::typekit

#endif
