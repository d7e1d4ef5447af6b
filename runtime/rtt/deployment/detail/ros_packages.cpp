// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ros_packages.hpp"

#include <rtt/Logger.hpp>
#include <rtt/plugin/search_path.hpp>

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

struct Found {
    std::string directory;
    std::vector<std::string> dependencies;
};
typedef std::map<std::string, Found> Packages;

/** Elements of package.xml (catkin, ament) that name what a package needs at run time. */
const char* const kRunTimeElements[] = {"depend", "run_depend", "exec_depend", "build_export_depend"};

std::string trimmed(const std::string& text) {
    const char* const blanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(blanks);
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/** The document in the file. Logs and returns nothing if it cannot be read. */
std::optional<xml::Document> documentOf(const fs::path& file) {
    oroforge::diag::Sink sink;
    auto document = xml::Document::parseFile(file.string(), sink);
    if (!document) log(Warning) << "ROS package not used: " << file.string() << " cannot be read" << endlog();
    return document;
}

/** Reads the newer format, in which the file has the name of the package. */
void readPackageXml(const fs::path& directory, Packages& packages) {
    const auto document = documentOf(directory / "package.xml");
    const xml::Element* const name = document ? document->root().child("name") : nullptr;
    if (!name) return;
    Found found = {directory.string(), {}};
    for (const char* const element : kRunTimeElements)
        for (const xml::Element* const one : document->root().childrenNamed(element))
            found.dependencies.push_back(trimmed(one->text));
    packages.emplace(trimmed(name->text), std::move(found));
}

/** Reads the older format, in which the package is named after its directory. */
void readManifestXml(const fs::path& directory, Packages& packages) {
    const auto document = documentOf(directory / "manifest.xml");
    if (!document) return;
    Found found = {directory.string(), {}};
    for (const xml::Element* const one : document->root().childrenNamed("depend"))
        found.dependencies.push_back(one->attributeOr("package", ""));
    packages.emplace(directory.filename().string(), std::move(found));
}

/** Collects the packages below a directory; a package has none inside. */
void collect(const fs::path& directory, Packages& packages) {
    std::error_code error;
    const auto has = [&](const char* file) { return fs::exists(directory / file, error); };
    if (has("CATKIN_IGNORE") || has("COLCON_IGNORE")) return;
    if (has("package.xml")) return readPackageXml(directory, packages);
    if (has("manifest.xml")) return readManifestXml(directory, packages);
    if (has("rospack_nosubdirs")) return;
    std::vector<fs::path> folders;
    for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        // Links to directories are not followed: they may lead back.
        if (name[0] != '.' && entry->symlink_status(error).type() == fs::file_type::directory)
            folders.push_back(entry->path());
    }
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) collect(folder, packages);
}

Packages allPackages() {
    Packages packages;  // if there are two of a name, the first is kept
    const char* const path = std::getenv("ROS_PACKAGE_PATH");
    for (const std::string& directory : splitPathList(path ? path : ""))
        if (isDirectory(directory)) collect(directory, packages);
    return packages;
}

void addWithDependencies(const std::string& name, const Packages& packages, std::set<std::string>& seen,
                         std::vector<RosPackage>& result) {
    const auto found = packages.find(name);
    if (found == packages.end() || !seen.insert(name).second) return;
    for (const std::string& dependency : found->second.dependencies)
        addWithDependencies(dependency, packages, seen, result);
    result.push_back({name, found->second.directory});
}

}  // namespace

std::vector<RosPackage> rosPackagesFor(const std::string& name) {
    std::vector<RosPackage> result;
    std::set<std::string> seen;
    addWithDependencies(name, allPackages(), seen, result);
    return result;
}

}  // namespace RTT::plugin
