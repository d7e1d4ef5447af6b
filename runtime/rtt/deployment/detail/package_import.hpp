// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds what `import` names and loads the libraries in it.
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

    /** A library file, an absolute directory, a package that is imported already, one on the search path, or of ROS. */
    void package(const std::string& name, const std::string& pathList);
    /** A package that is imported already, or one on the search path; what lies in the current folder is not looked at. */
    void installed(const std::string& name, const std::string& pathList);
    /** Each directory and its target sub-directory. */
    void directories(const std::vector<std::string>& directories);

    /** What went wrong; empty if all was imported. */
    const std::vector<std::string>& errors() const { return errors_; }
    /** True if libraries were found that cannot be loaded. */
    bool hasBrokenLibraries() const { return broken_; }

private:
    void libraryFile(const std::string& file);
    void fromSearchPath(const std::string& name, const std::vector<std::string>& given, bool here);
    /** A ROS package, with those it depends on; false if there is none of the name. */
    bool fromRos(const std::string& name);
    void importAll(const std::string& what, const std::vector<std::string>& directories);
    bool importDirectory(const std::string& directory);

    ComponentTable& table_;
    std::vector<std::string> errors_;
    std::vector<std::string> libraries_;  // of components, that are loaded now
    std::string others_;                  // libraries that hold none, and why
    bool broken_ = false;
};

}  // namespace RTT::plugin

#endif
