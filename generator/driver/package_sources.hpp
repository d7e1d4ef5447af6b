// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which files of a package may hold a class of the user.
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

/// C++ files that define one of the classes, given by their names without namespaces, or members of one. Hidden folders
/// and build trees are left out.
PackageSources findSources(const std::filesystem::path& root, const std::vector<std::string>& classNames);

/// Whether a text has "class NAME", "struct NAME" or "NAME::member(".
bool definesClass(const std::string& text, const std::string& name);

}  // namespace oroforge::driver

#endif
