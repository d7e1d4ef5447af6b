// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// typegen --check: compares committed files with what typegen would generate now.
#ifndef OROFORGE_TYPEKIT_GEN_DRIVER_CHECK_OUTPUT_HPP
#define OROFORGE_TYPEKIT_GEN_DRIVER_CHECK_OUTPUT_HPP

#include <filesystem>
#include <string>

#include <diag/sink.hpp>
#include <emit/outputs.hpp>

namespace oroforge::typekit {

/// Only reads. Returns false after an error TK067 for each file that differs, is missing, or was written by typegen but
/// is no longer made. The last error says how to refresh them.
bool checkOutput(const emit::Outputs& outputs, const std::filesystem::path& folder, const std::string& refresh,
                 diag::Sink& sink);

/// Removes sources of types (types_*.cpp) that an earlier run left in `folder`, because a build may compile every file
/// in it. Only files with typegen's banner are removed. Returns their paths.
std::vector<std::string> removeSuperfluousSources(const emit::Outputs& outputs, const std::filesystem::path& folder);

}  // namespace oroforge::typekit

#endif
