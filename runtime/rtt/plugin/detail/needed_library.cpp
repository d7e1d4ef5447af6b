// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "needed_library.hpp"

#include <rtt/Logger.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/plugin/search_path.hpp>
#include <rtt/plugin/shared_library.hpp>
#include <rtt/rtt-config.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace RTT::plugin {
namespace {

std::vector<std::string> foldersIn(const std::string& directory) {
    std::vector<std::string> folders;
    std::error_code error;
    for (std::filesystem::directory_iterator at(directory, error), end; !error && at != end; at.increment(error))
        if (isDirectory(at->path().string())) folders.push_back(at->path().string());
    std::sort(folders.begin(), folders.end());
    return folders;
}

std::string inPackage(const std::string& folder, const std::string& library) {
    for (const char* part : {"/types/", "/plugins/", "/"})
        if (isFile(folder + part + library)) return folder + part + library;
    return {};
}

/** The first file of that name in the order of the search path; empty if there is none. */
std::string fileOfLibrary(const std::string& library, const std::string& pathList) {
    for (const std::string& path : splitPathList(pathList)) {
        for (const std::string& base : withTargetDirectory(path)) {
            if (std::string file = inPackage(base, library); !file.empty()) return file;
            for (const std::string& package : foldersIn(base))
                if (std::string file = inPackage(package, library); !file.empty()) return file;
        }
        // A prefix has packages in lib/orocos, and libraries that they share in lib.
        const std::string beside = parentPath(path) + "/" + library;
        if (fileName(path) == "orocos" && isFile(beside)) return beside;
    }
    return {};
}

/** What follows "install the package" for a library. Typekits and plugins are named after their package; others need
    not be. */
std::string packageToInstall(const std::string& library) {
    const std::string name = shortName(library);
    for (const std::string end : {"-typekit", "-plugin"})
        if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
            return "'" + name.substr(0, name.size() - end.size()) + "'";
    return "that has it";
}

bool load(const std::string& file, std::string& error) {
    const std::string folder = fileName(parentPath(file));
    if (folder == "types" || folder == "plugins") return PluginLoader::Instance()->loadLibrary(file, error);
    SharedLibrary library(file, SharedLibrary::Local, error);
    if (!library) return false;
    library.keep();
    return true;
}

}  // namespace

std::string notFoundLibrary(const std::string& linkerText, const std::string& file) {
    // "libarm.so.1: cannot open shared object file: …"; the words after the name are in the language of the user.
    const std::string name = linkerText.substr(0, linkerText.find(": "));
    const bool isLibrary = name.size() < linkerText.size() && name.find(".so") != std::string::npos;
    return isLibrary && name.find('/') == std::string::npos && name != fileName(file) ? name : std::string();
}

bool loadNeeded(const std::string& library, std::string& error) {
    const std::string path = PluginLoader::Instance()->getPluginPath();
    const std::string file = fileOfLibrary(library, path);
    if (file.empty()) {
        error = "it needs " + library + ", which is not found; install the package " + packageToInstall(library) +
                ", or add the folder lib/orocos of its prefix to the search path (RTT_COMPONENT_PATH), which is " +
                path;
        return false;
    }
    if (!load(file, error)) {
        error = "it needs " + file + ", which cannot be loaded: " + error;
        return false;
    }
    log(Info) << "loaded " << file << ", which another library needs" << endlog();
    return true;
}

}  // namespace RTT::plugin
