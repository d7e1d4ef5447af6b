// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the files of a package that may contain a class of the user.
#ifndef OROFORGE_GENERATOR_DRIVER_PACKAGE_SOURCES_HPP
#define OROFORGE_GENERATOR_DRIVER_PACKAGE_SOURCES_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace oroforge::driver {

struct PackageSources {
    std::vector<std::string> sources;  ///< relative to the package, sorted
    std::vector<std::string> headers;
};

/// Returns C++ files that define one of the classes (without namespaces) or a member. Skips hidden and build folders.
PackageSources findSources(const std::filesystem::path& root, const std::vector<std::string>& classNames);

/// True if a text has "class NAME", "struct NAME" or "NAME::member(".
bool definesClass(const std::string& text, const std::string& name);

}  // namespace oroforge::driver

#endif
