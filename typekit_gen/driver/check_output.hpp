// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// typegen --check: is what was generated, and then committed, still what would be generated?
#ifndef OROFORGE_TYPEKIT_GEN_DRIVER_CHECK_OUTPUT_HPP
#define OROFORGE_TYPEKIT_GEN_DRIVER_CHECK_OUTPUT_HPP

#include <filesystem>
#include <string>

#include <diag/sink.hpp>
#include <emit/outputs.hpp>

namespace oroforge::typekit {

/// Reads only. False, and an error TK067 for each file that differs, is missing, or is of typegen's but no longer made;
/// the last of them says how to refresh them.
bool checkOutput(const emit::Outputs& outputs, const std::filesystem::path& folder, const std::string& refresh,
                 diag::Sink& sink);

/// Removes sources of types (types_*.cpp) that an earlier run has left in `folder`, and nothing without the banner of typegen:
/// a build that compiles all that it finds there is not to compile them. Returns their paths.
std::vector<std::string> removeSuperfluousSources(const emit::Outputs& outputs, const std::filesystem::path& folder);

}  // namespace oroforge::typekit

#endif
