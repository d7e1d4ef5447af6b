// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds what an import names, and loads its libraries.
#ifndef OROFORGE_PACKAGE_IMPORT_HPP
#define OROFORGE_PACKAGE_IMPORT_HPP

#include "component_table.hpp"

#include <string>
#include <vector>

namespace RTT::plugin {

/** One call of import. A library that cannot be loaded does not keep the others from being loaded. */
class PackageImport {
public:
    explicit PackageImport(ComponentTable& table) : table_(table) {}

    /** Imports a library file, an absolute directory, or a package on the search path or of ROS, unless imported
        already. */
    void package(const std::string& name, const std::string& pathList);
    /** Imports a ROS package after those that its package.xml names as `plugin_depend`, each once. */
    void ros(const std::string& name, const std::string& pathList);
    /** Imports a package on the search path, but not from the current folder, unless imported already. Component
        libraries that list their types in their file wait until one is needed. */
    void installed(const std::string& name, const std::string& pathList);
    /** Imports each directory and its target sub-directory. */
    void directories(const std::vector<std::string>& directories);

    /** The errors; empty if everything was imported. */
    const std::vector<std::string>& errors() const { return errors_; }
    /** True if libraries were found that cannot be loaded. */
    bool hasBrokenLibraries() const { return broken_; }

private:
    void libraryFile(const std::string& file);
    void fromSearchPath(const std::string& name, const std::vector<std::string>& given, bool here);
    /** Imports a ROS package after those on which it depends. False if there is none of that name; its file may have a
        problem. */
    bool fromRos(const std::string& name, std::string& problem);
    void importAll(const std::string& what, const std::vector<std::string>& directories);
    bool importDirectory(const std::string& directory);
    /** False if the file does not list its types, so that only loading it tells them. */
    bool defer(const std::string& file);
    /** Loads the libraries of an imported package that wait. */
    bool loadAllOf(const std::string& package);

    ComponentTable& table_;
    std::vector<std::string> errors_;
    std::vector<std::string> libraries_;  // component libraries that are loaded now
    std::string others_;                  // libraries without components, and why
    bool broken_ = false;
    bool mayDefer_ = false;
};

}  // namespace RTT::plugin

#endif
