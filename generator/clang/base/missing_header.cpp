// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "missing_header.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace fs = std::filesystem;

namespace oroforge::cxx {

namespace {

bool isFileAt(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

/// Returns the nearest folder above that is a package; the file's folder if there is none.
fs::path packageOf(const fs::path& file) {
    for (fs::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
        for (const char* sign : {"package.xml", "manifest.xml", "CMakeLists.txt"})
            if (isFileAt(folder / sign)) return folder;
    }
    return file.parent_path();
}

/// Sorts folders, because file systems have no fixed order.
std::vector<fs::path> foldersIn(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code error, ignored;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::directory_iterator it(folder, options, error), end; !error && it != end; it.increment(error))
        if (it->is_directory(ignored)) found.push_back(it->path());
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<fs::path> likelyFolders(const fs::path& includer) {
    const fs::path package = packageOf(includer);
    std::vector<fs::path> folders;
    for (fs::path folder = includer.parent_path();; folder = folder.parent_path()) {
        folders.push_back(folder);
        if (folder == package || !folder.has_relative_path()) break;
    }
    folders.push_back(package / "include");
    for (const char* sign : {"package.xml", "manifest.xml", "CMakeLists.txt"}) {
        if (!isFileAt(package / sign)) continue;
        for (const fs::path& beside : foldersIn(package.parent_path())) folders.push_back(beside / "include");
        break;
    }
    for (const char* system : {"/usr/local/include", "/usr/include"})
        for (const fs::path& folder : foldersIn(system)) folders.push_back(folder);
    return folders;
}

/// Shortens a path as a user would write it.
std::string shown(const fs::path& folder) {
    std::error_code ignored;
    const fs::path relative = folder.lexically_relative(fs::current_path(ignored));
    return relative.empty() || *relative.begin() == ".." ? folder.string() : relative.string();
}

}  // namespace

std::string folderHint(const std::string& name, const std::string& includer) {
    std::error_code error;
    const fs::path from = fs::absolute(includer, error).lexically_normal();
    if (name.empty() || error) return {};
    for (const fs::path& folder : likelyFolders(from))
        if (isFileAt(folder / name)) return "it is in " + shown(folder) + ": pass -I " + shown(folder);
    for (const char* part : {"rtt", "ocl"}) {
        if (name.rfind(std::string(part) + "/", 0) == 0)
            return std::string("the toolchain's headers are not beside this program: pass -i orocos-") + part +
                   ", or -I with the folder that holds " + part + "/";
    }
    return {};
}

}  // namespace oroforge::cxx
