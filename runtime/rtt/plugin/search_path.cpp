// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "search_path.hpp"

#include <rtt/plugin/shared_library.hpp>
#include <rtt/rtt-config.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace RTT::plugin {
namespace {

/** The position of `.so` or `.so.N[.N…]` at the end of a file name, npos if it has another suffix. */
std::size_t librarySuffix(const std::string& name) {
    const std::size_t at = name.rfind(".so");
    if (at == std::string::npos || at == 0) return std::string::npos;
    const bool versionOnly =
        std::all_of(name.begin() + at + 3, name.end(), [](unsigned char c) { return c == '.' || std::isdigit(c); });
    const bool startsWithDot = name.size() == at + 3 || name[at + 3] == '.';
    return versionOnly && startsWithDot ? at : std::string::npos;
}

}  // namespace

std::vector<std::string> splitPathList(const std::string& list) {
    std::vector<std::string> paths;
    std::size_t begin = 0;
    while (begin <= list.size()) {
        const std::size_t end = std::min(list.find_first_of(":;", begin), list.size());
        std::string path = list.substr(begin, end - begin);
        while (path.size() > 1 && path.back() == '/') path.pop_back();
        if (!path.empty() && std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
        begin = end + 1;
    }
    return paths;
}

std::string defaultSearchPath() {
    std::string list;
    if (const char* environment = std::getenv("RTT_COMPONENT_PATH")) list = environment;
    // Looked up at run time, so that an installation can be moved.
    const std::string self = SharedLibrary::fileWith(reinterpret_cast<const void*>(&defaultSearchPath));
    if (!self.empty()) list += ":" + parentPath(canonicalPath(self)) + "/orocos";
    std::string clean;
    for (const std::string& path : splitPathList(list)) clean += (clean.empty() ? "" : ":") + path;
    return clean;
}

std::vector<std::string> withTargetDirectory(const std::string& directory) {
    std::vector<std::string> found;
    if (isDirectory(directory)) found.push_back(directory);
    const std::string below = directory + "/" OROCOS_TARGET_NAME;
    if (fileName(directory) != OROCOS_TARGET_NAME && isDirectory(below)) found.push_back(below);
    return found;
}

std::vector<std::string> librariesIn(const std::string& directory) {
    std::vector<std::string> files;
    std::error_code error;
    for (fs::directory_iterator at(directory, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (librarySuffix(name) != std::string::npos && isFile(at->path().string()))
            files.push_back(directory + "/" + name);
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool isDirectory(const std::string& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

bool isFile(const std::string& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

std::string canonicalPath(const std::string& path) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    return error ? path : real.string();
}

std::string absolutePath(const std::string& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    return error ? path : absolute.lexically_normal().string();
}

std::string fileName(const std::string& path) {
    const std::size_t last = path.find_last_not_of('/');
    if (last == std::string::npos) return path;
    const std::size_t slash = path.rfind('/', last);
    const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
    return path.substr(begin, last + 1 - begin);
}

std::string parentPath(const std::string& path) {
    const std::string parent = fs::path(path).parent_path().string();
    return parent.empty() ? "." : parent;
}

std::string shortName(const std::string& path) {
    std::string name = fileName(path);
    if (const std::size_t suffix = librarySuffix(name); suffix != std::string::npos) name.resize(suffix);
    const std::string target = "-" OROCOS_TARGET_NAME;
    if (name.size() > target.size() && name.compare(name.size() - target.size(), target.size(), target) == 0)
        name.resize(name.size() - target.size());
    if (name.size() > 3 && name.compare(0, 3, "lib") == 0) name.erase(0, 3);
    return name;
}

std::vector<std::string> fileNamesOf(const std::string& shortName) {
    const std::string suffixed = shortName + "-" OROCOS_TARGET_NAME ".so";
    return {"lib" + suffixed, suffixed, "lib" + shortName + ".so", shortName + ".so"};
}

}  // namespace RTT::plugin
