// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "toolchain_flags.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace oroforge::cxx {

namespace {

bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

/// Returns the source folder of a build tree, from its CMake cache.
fs::path sourcesOf(const fs::path& buildTree) {
    const std::string key = "CMAKE_HOME_DIRECTORY:INTERNAL=";
    std::ifstream cache(buildTree / "CMakeCache.txt");
    for (std::string line; std::getline(cache, line);) {
        if (line.compare(0, key.size(), key) == 0) return line.substr(key.size());
    }
    return {};
}

/// If repeated, such a folder would come before the standard library, whose #include_next then finds nothing.
bool isOfCompiler(const fs::path& folder) { return folder == "/usr/include" || folder == "/usr/local/include"; }

bool names(const std::string& word, const fs::path& folder) {
    std::error_code ignored;
    const std::string path = word.compare(0, 2, "-I") == 0 ? word.substr(2) : word;
    return !path.empty() && fs::equivalent(path, folder, ignored);
}

std::vector<std::string> flagsFor(const std::vector<fs::path>& folders) {
    std::vector<std::string> flags;
    for (const fs::path& folder : folders) {
        if (isThere(folder) && !isOfCompiler(folder)) flags.insert(flags.end(), {"-isystem", folder.string()});
    }
    return flags;
}

}  // namespace

std::vector<std::string> toolchainFlags(const std::string& executable) {
    std::error_code error;
    const fs::path program = fs::canonical(executable, error);
    if (error) return {};
    const fs::path include = program.parent_path().parent_path() / "include";
    if (isThere(include / "rtt/TaskContext.hpp") || isThere(include / "orocos/rtt/TaskContext.hpp"))
        return flagsFor({include, include / "orocos"});
    for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
        if (!isThere(folder / "CMakeCache.txt")) continue;
        const fs::path sources = sourcesOf(folder);
        return flagsFor({sources / "runtime", sources / "deployer", folder / "include"});
    }
    return {};
}

std::vector<std::string> toolchainFlags() { return toolchainFlags("/proc/self/exe"); }

std::vector<std::string> toolchainFlagsBesides(const std::vector<std::string>& flags) {
    std::vector<std::string> more;
    const std::vector<std::string> all = toolchainFlags();
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
        const auto isNamed = [&](const std::string& word) { return names(word, all[i + 1]); };
        if (std::none_of(flags.begin(), flags.end(), isNamed)) more.insert(more.end(), {all[i], all[i + 1]});
    }
    return more;
}

}  // namespace oroforge::cxx
