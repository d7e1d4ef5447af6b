// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "package_import.hpp"

#include "listed_types.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/Logger.hpp>
#include <rtt/deployment/ros_packages.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/plugin/search_path.hpp>
#include <rtt/rtt-config.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace RTT::plugin {
namespace {

bool isAbsolute(const std::string& path) { return !path.empty() && path[0] == '/'; }

/** The existing directories of a package below one search directory. */
std::vector<std::string> packageDirectories(const std::string& path, const std::string& name) {
    std::vector<std::string> found;
    for (const std::string& directory : {path + "/" + name, path + "/" OROCOS_TARGET_NAME "/" + name})
        if (isDirectory(directory)) found.push_back(directory);
    return found;
}

bool holdsLibraries(const std::string& directory) {
    for (const char* part : {"", "/types", "/plugins"})
        if (!librariesIn(directory + part).empty()) return true;
    return false;
}

bool holdLibraries(const std::vector<std::string>& directories) {
    return std::any_of(directories.begin(), directories.end(), holdsLibraries);
}

/** The packages below search directories, by name. */
std::vector<std::string> packagesIn(const std::vector<std::string>& paths) {
    std::vector<std::string> names;
    for (const std::string& path : paths)
        for (const std::string& parent : {path, path + "/" OROCOS_TARGET_NAME}) {
            std::error_code ignored;  // of a directory that does not exist or cannot be read
            std::filesystem::directory_iterator entry(parent, ignored);
            for (; entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
                const std::string name = entry->path().filename();
                if (name == OROCOS_TARGET_NAME || name == "types" || name == "plugins") continue;
                if (holdLibraries(withTargetDirectory(entry->path()))) names.push_back(name);
            }
        }
    return names;
}

/** Those of a ROS package below the first search path that has libraries of it. The one of its own folder need not name
    it. */
std::vector<std::string> directoriesOf(const std::string& name, const std::vector<std::string>& paths,
                                       const std::string& own) {
    for (const std::string& path : paths) {
        std::vector<std::string> directories;
        if (!own.empty() && path == own + "/lib/orocos") directories = withTargetDirectory(path);
        for (const std::string& directory : packageDirectories(path, name)) directories.push_back(directory);
        if (holdLibraries(directories)) return directories;
    }
    return {};
}

std::string rosPackageMissing(const std::string& name, const std::string& by, const std::string& problem,
                              const std::vector<std::string>& paths) {
    const std::string text =
        "there is no package '" + name + "'" + (by.empty() ? "" : ", which package.xml of '" + by + "' names");
    if (!problem.empty()) return text + ": " + problem;
    return text + "; ROS_PACKAGE_PATH and CMAKE_PREFIX_PATH say where packages are" +
           oroforge::diag::didYouMean(name, packagesIn(paths));
}

}  // namespace

void PackageImport::package(const std::string& name, const std::string& pathList) {
    if (name.empty()) {
        errors_.push_back("the name of the package is empty");
        return;
    }
    if (isFile(name)) return libraryFile(name);
    if (isAbsolute(name)) {
        const std::vector<std::string> directories = withTargetDirectory(name);
        if (directories.empty())
            errors_.push_back("no such file or directory: " + name);
        else
            importAll(name, directories);
        return;
    }
    if (table_.isImported(name)) {
        if (!loadAllOf(name)) return;
        log(Info) << "component package '" << name << "' is already imported" << endlog();
        PluginLoader::Instance()->importAgain(name);
        return;
    }
    // A folder of that name in the current one goes first, unless it has no libraries: then it may be the package's
    // source.
    const std::vector<std::string> here = withTargetDirectory("./" + name);
    if (holdLibraries(here)) return importAll(name, here);
    fromSearchPath(name, splitPathList(pathList), true);
}

void PackageImport::installed(const std::string& name, const std::string& pathList) {
    mayDefer_ = true;
    if (!table_.isImported(name)) fromSearchPath(name, splitPathList(pathList), false);
}

bool PackageImport::loadAllOf(const std::string& package) {
    const std::vector<std::string> errors = table_.loadDeferredOf(package);
    errors_.insert(errors_.end(), errors.begin(), errors.end());
    broken_ |= !errors.empty();
    return errors.empty();
}

void PackageImport::directories(const std::vector<std::string>& directories) {
    std::vector<std::string> existing;
    for (const std::string& directory : directories)
        for (const std::string& found : withTargetDirectory(directory)) existing.push_back(found);
    if (existing.empty())
        errors_.push_back("no such directory");
    else
        importAll(existing.front(), existing);
}

void PackageImport::libraryFile(const std::string& file) {
    const ComponentTable::LoadResult result = table_.loadLibrary(file);
    if (!result.error.empty()) errors_.push_back(file + ": " + result.error);
}

/** With `here`, also searches the current folder, after the others. */
void PackageImport::fromSearchPath(const std::string& name, const std::vector<std::string>& given, bool here) {
    std::vector<std::string> paths = given;
    if (here && std::find(paths.begin(), paths.end(), ".") == paths.end()) paths.push_back(".");
    std::vector<std::string> first;
    std::string sources;
    std::string text;
    for (const std::string& path : paths) {
        const std::vector<std::string> directories = packageDirectories(path, name);
        text += (text.empty() ? "" : ", ") + path;
        if (directories.empty()) continue;
        if (path == "." && first.empty() && !holdLibraries(directories)) {
            sources = "; " + directories.front() + " has no components, typekits or plugins";
            continue;
        }
        // Paths are overlays: the first one that has it hides the others.
        if (first.empty())
            first = directories;
        else
            log(Info) << "package '" << name << "' is in " << directories.front() << ", too: using that in "
                      << first.front() << endlog();
    }
    if (!first.empty()) return importAll(name, first);
    std::string problem;
    if (fromRos(name, problem)) return;
    errors_.push_back("no such package or directory in the search path: " + text + sources +
                      oroforge::diag::didYouMean(name, packagesIn(given)));
    if (!problem.empty()) errors_.push_back(problem);
}

bool PackageImport::fromRos(const std::string& name, std::string& problem) {
    RosPackages packages;
    const std::vector<RosPackage> needed = packages.withDependencies(name);
    bool found = false;
    for (const RosPackage& package : needed) {
        // Packages on which it depends may have no components, and the package itself may only name others.
        if (table_.isImported(package.name)) {
            (void)loadAllOf(package.name);
            found = true;
            continue;
        }
        const std::vector<std::string> directories =
            directoriesOf(package.name, packages.libraryPaths(package), package.directory);
        if (directories.empty()) continue;
        found = true;
        importAll(package.name, directories);
    }
    if (!needed.empty() && !found)
        errors_.push_back("ROS package '" + name + "' has no components, typekits or plugins in " +
                          needed.back().directory + "/lib/orocos");
    problem = packages.problem(name);
    return !needed.empty();
}

void PackageImport::ros(const std::string& name, const std::string& pathList) {
    if (name.empty()) {
        errors_.push_back("the name of the package is empty");
        return;
    }
    RosPackages packages;
    std::set<std::string> seen = {"rtt_ros"};
    const auto bring = [&](const auto& self, const std::string& one, const std::string& by) -> void {
        if (!seen.insert(one).second) return;
        if (table_.isImported(one)) {
            if (loadAllOf(one)) PluginLoader::Instance()->importAgain(one);
            return;
        }
        const RosPackage* const package = packages.find(one);
        std::vector<std::string> paths = splitPathList(pathList);
        if (package) {
            for (const std::string& plugin : package->plugins) self(self, plugin, one);
            // A rosbuild package is not installed: what is built in its own folder hides what others have of it.
            const std::vector<std::string> more = packages.libraryPaths(*package);
            const bool isManifest = isFile(package->directory + "/manifest.xml");
            paths.insert(isManifest ? paths.begin() : paths.end(), more.begin(), more.end());
        }
        const std::vector<std::string> directories = directoriesOf(one, paths, package ? package->directory : "");
        PackageImport libraries(table_);
        if (!directories.empty())
            libraries.importAll(one, directories);
        else if (package)
            log(Info) << "ROS package '" << one << "' in " << package->directory
                      << " has no components, typekits or plugins" << endlog();
        else
            libraries.errors_.push_back(rosPackageMissing(one, by, packages.problem(one), paths));
        errors_.insert(errors_.end(), libraries.errors_.begin(), libraries.errors_.end());
        broken_ |= libraries.broken_;
    };
    bring(bring, name, "");
}

void PackageImport::importAll(const std::string& what, const std::vector<std::string>& directories) {
    bool found = false;
    std::string text;
    for (const std::string& directory : directories) {
        found |= importDirectory(directory);
        text += (text.empty() ? "" : ", ") + directory;
    }
    if (found && !broken_)
        table_.addPackage(what, libraries_);  // unless it is broken, so that a second attempt shows the errors again
    else if (!found && !broken_)
        errors_.push_back("no components, typekits or plugins in " + text + others_);
}

bool PackageImport::defer(const std::string& file) {
    std::vector<std::string> types = listedTypes(file);
    if (types.empty()) return false;
    table_.defer(file, std::move(types));
    libraries_.push_back(canonicalPath(file));
    return true;
}

bool PackageImport::importDirectory(const std::string& directory) {
    log(Info) << "importing directory " << directory << endlog();
    bool found = false;
    for (const std::string& file : librariesIn(directory)) {
        if (mayDefer_ && defer(file)) {
            found = true;
            continue;
        }
        const ComponentTable::LoadResult result = table_.loadLibrary(file);
        if (result.error.empty()) {
            found = true;
            libraries_.push_back(canonicalPath(file));
        } else if (result.noComponents) {
            // Libraries on which components depend are often in the same folder.
            log(Info) << "'" << file << "' holds no components: " << result.error << endlog();
            others_ += "; " + file + ": " + result.error;
        } else {
            errors_.push_back(file + ": " + result.error);
            broken_ = true;
        }
    }
    const PluginLoader::Scan plugins = PluginLoader::Instance()->importDirectory(directory);
    errors_.insert(errors_.end(), plugins.errors.begin(), plugins.errors.end());
    broken_ |= !plugins.errors.empty();
    return found || plugins.found > plugins.errors.size();
}

}  // namespace RTT::plugin
