// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ros_packages.hpp"

#include <rtt/Logger.hpp>
#include <rtt/plugin/search_path.hpp>
#include <rtt/plugin/shared_library.hpp>

#include <diag/print.hpp>
#include <diag/sink.hpp>
#include <xml/document.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace RTT::plugin {
namespace {

namespace fs = std::filesystem;
namespace xml = oroforge::xml;

typedef std::map<std::string, RosPackage> Packages;
typedef std::map<std::string, std::string> Problems;  // by name and by folder

/** Elements of package.xml that name what a package needs at run time. */
const char* const kRunTimeElements[] = {"depend", "run_depend", "exec_depend", "build_export_depend"};

std::string trimmed(const std::string& text) {
    const char* const blanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(blanks);
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/** A folder in which packages are looked for, and those that were found. */
struct Place {
    explicit Place(std::string folder) : directory(std::move(folder)), isShare(fileName(directory) == "share") {}

    std::string directory;
    bool isShare;  // large, with packages directly in it
    bool isRead = false;
    Packages packages;  // if there are two of a name, the first is kept
};

class Reader {
public:
    Reader(Packages& packages, Problems& problems) : packages_(packages), problems_(problems) {}

    /** Reads the package in the directory, if there is one. */
    bool package(const fs::path& directory) {
        if (has(directory, "package.xml")) return packageXml(directory), true;
        if (has(directory, "manifest.xml")) return manifestXml(directory), true;
        return false;
    }

    /** Reads the packages below a directory; a package has none inside. */
    void below(const fs::path& directory) {
        if (has(directory, "CATKIN_IGNORE") || has(directory, "COLCON_IGNORE")) return;
        if (package(directory) || has(directory, "rospack_nosubdirs")) return;
        std::error_code error;
        std::vector<fs::path> folders;
        for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error)) {
            const std::string name = entry->path().filename().string();
            // Links to directories are not followed: they may lead back.
            if (name[0] != '.' && entry->symlink_status(error).type() == fs::file_type::directory)
                folders.push_back(entry->path());
        }
        std::sort(folders.begin(), folders.end());
        for (const fs::path& folder : folders) below(folder);
    }

private:
    static bool has(const fs::path& directory, const char* file) {
        std::error_code error;
        return fs::exists(directory / file, error);
    }

    void problem(const fs::path& directory, const std::string& text) {
        log(Warning) << "ROS package not used: " << text << endlog();
        problems_.emplace(directory.filename().string(), text);
    }

    std::optional<xml::Document> documentOf(const fs::path& file) {
        oroforge::diag::Sink sink;
        auto document = xml::Document::parseFile(file.string(), sink);
        if (!document)
            problem(file.parent_path(), sink.empty() ? file.string() + ": error: cannot be read"
                                                     : oroforge::diag::toString(sink.all().front()));
        return document;
    }

    static void takePlugins(const xml::Element& root, RosPackage& package) {
        for (const xml::Element* const exported : root.childrenNamed("export"))
            for (const xml::Element* const ours : exported->childrenNamed("rtt_ros"))
                for (const xml::Element* const one : ours->childrenNamed("plugin_depend"))
                    package.plugins.push_back(trimmed(one->text));
    }

    /** The newer format, in which the file has the name of the package. */
    void packageXml(const fs::path& directory) {
        const auto document = documentOf(directory / "package.xml");
        if (!document) return;
        const xml::Element* const name = document->root().child("name");
        const std::string text = name ? trimmed(name->text) : "";
        if (text.empty()) {
            const auto& where = name ? name->location() : document->root().location();
            return problem(directory, oroforge::diag::toString(where) + ": error: the package has no name");
        }
        RosPackage found = {text, directory.string(), {}, {}};
        for (const char* const element : kRunTimeElements)
            for (const xml::Element* const one : document->root().childrenNamed(element))
                found.dependencies.push_back(trimmed(one->text));
        takePlugins(document->root(), found);
        packages_.emplace(text, std::move(found));
    }

    /** The older format, in which the package is named after its directory. */
    void manifestXml(const fs::path& directory) {
        const auto document = documentOf(directory / "manifest.xml");
        if (!document) return;
        RosPackage found = {directory.filename().string(), directory.string(), {}, {}};
        for (const xml::Element* const one : document->root().childrenNamed("depend"))
            found.dependencies.push_back(one->attributeOr("package", ""));
        takePlugins(document->root(), found);
        packages_.emplace(found.name, std::move(found));
    }

    Packages& packages_;
    Problems& problems_;
};

std::vector<std::string> listIn(const char* variable) {
    const char* const list = std::getenv(variable);
    return splitPathList(list ? list : "");
}

/** The folder above that of the runtime's library. */
std::string ownPrefix() {
    const std::string library = SharedLibrary::fileWith(reinterpret_cast<const void*>(&listIn));
    return parentPath(parentPath(canonicalPath(library)));
}

}  // namespace

struct RosPackages::Impl {
    Impl() {
        for (const std::string& directory : listIn("ROS_PACKAGE_PATH")) add(directory);
        prefixes = listIn("CMAKE_PREFIX_PATH");
        prefixes.push_back(ownPrefix());
        for (const std::string& prefix : prefixes) add(prefix + "/share");
        add("/usr/share");
    }

    void add(const std::string& directory) {
        const auto isThis = [&](const Place& place) { return place.directory == directory; };
        if (std::none_of(places.begin(), places.end(), isThis)) places.emplace_back(directory);
    }

    const RosPackage* findIn(Place& place, const std::string& name) {
        const auto known = place.packages.find(name);
        if (known != place.packages.end()) return &known->second;
        Reader reader(place.packages, problems);
        if (place.isShare) {
            if (!isDirectory(place.directory + "/" + name) || !reader.package(place.directory + "/" + name))
                return nullptr;
        } else if (!place.isRead && isDirectory(place.directory)) {
            place.isRead = true;
            reader.below(place.directory);
        }
        const auto found = place.packages.find(name);
        return found == place.packages.end() ? nullptr : &found->second;
    }

    std::vector<Place> places;
    std::vector<std::string> prefixes;
    Problems problems;
};

RosPackages::RosPackages() : impl_(new Impl) {}
RosPackages::~RosPackages() = default;

const RosPackage* RosPackages::find(const std::string& name) {
    if (name.empty() || name.find('/') != std::string::npos || name[0] == '.') return nullptr;
    for (Place& place : impl_->places)
        if (const RosPackage* const found = impl_->findIn(place, name)) return found;
    return nullptr;
}

std::vector<RosPackage> RosPackages::withDependencies(const std::string& name) {
    std::vector<RosPackage> result;
    std::set<std::string> seen;
    const auto add = [&](const auto& self, const std::string& one) -> void {
        if (!seen.insert(one).second) return;
        const RosPackage* const found = find(one);
        if (!found) return;
        for (const std::string& dependency : found->dependencies) self(self, dependency);
        result.push_back(*found);
    };
    add(add, name);
    return result;
}

std::string RosPackages::problem(const std::string& name) const {
    const auto found = impl_->problems.find(name);
    return found == impl_->problems.end() ? "" : found->second;
}

std::vector<std::string> RosPackages::libraryPaths(const RosPackage& package) const {
    std::vector<std::string> paths = {package.directory + "/lib/orocos"};
    if (fileName(parentPath(package.directory)) == "share")
        paths.push_back(parentPath(parentPath(package.directory)) + "/lib/orocos");
    for (const std::string& prefix : impl_->prefixes) paths.push_back(prefix + "/lib/orocos");
    return paths;
}

}  // namespace RTT::plugin
