// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Checks the types and defaults of a manifest against the headers of its typekit: what C++ would say of generated files is
/// told of the manifest.
#ifndef OROFORGE_GENERATOR_DRIVER_MANIFEST_TYPES_HPP
#define OROFORGE_GENERATOR_DRIVER_MANIFEST_TYPES_HPP

#include <filesystem>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::driver {

/// Reports OM024, OM025 and OM036. `folder`: where the headers of the manifest lie. Where one is missing or makes no sense
/// only slips in the names of C++'s own types are reported, as all others may be defined in it. Gives the headers that
/// were read.
std::vector<std::string> checkTypes(const model::Package& package, const std::filesystem::path& folder,
                                    const std::vector<std::string>& flags, diag::Sink& sink);

}  // namespace oroforge::driver

#endif
