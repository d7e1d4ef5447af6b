// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Checks the types and defaults of a manifest against the headers of its typekit: errors that C++ would find in
/// generated files are reported in the manifest.
#ifndef OROFORGE_GENERATOR_DRIVER_MANIFEST_TYPES_HPP
#define OROFORGE_GENERATOR_DRIVER_MANIFEST_TYPES_HPP

#include <filesystem>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::driver {

/// Reports OM024, OM025 and OM036; returns the headers that were read. `folder` has the headers of the manifest. If one
/// is missing or malformed, only misspelt names of C++'s own types are reported, because it may define all others.
std::vector<std::string> checkTypes(const model::Package& package, const std::filesystem::path& folder,
                                    const std::vector<std::string>& flags, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
