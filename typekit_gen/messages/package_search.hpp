// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the folders with the .msg and .srv files of packages, without any program of ROS.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_PACKAGE_SEARCH_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_PACKAGE_SEARCH_HPP

#include <map>
#include <string>
#include <vector>

namespace oroforge::messages {

/// First come the folders that were added; then packages below the folders of ROS_PACKAGE_PATH, `share/<package>` of
/// the prefixes in CMAKE_PREFIX_PATH, and /usr/share/<package>. Reads the environment when it is made.
class PackageSearch {
public:
    PackageSearch();

    /// `folder` holds .msg files of the package.
    void add(const std::string& package, const std::string& folder);

    /// Returns the folders of the package that exist and may hold files of a kind ("msg" or "srv").
    std::vector<std::string> foldersOf(const std::string& package, const std::string& kind);

    /// Returns the folder with the package.xml of the package, "" if there is none.
    std::string folderOf(const std::string& package);

    /// Returns what is searched, for error messages.
    std::string described() const;

private:
    const std::vector<std::string>& roots(const std::string& package);
    void crawl(const std::string& folder, int depth);

    std::map<std::string, std::vector<std::string>> added_;
    std::vector<std::string> workspaces_;  ///< ROS_PACKAGE_PATH
    std::vector<std::string> shares_;
    std::map<std::string, std::vector<std::string>> roots_;
    std::map<std::string, std::vector<std::string>> crawled_;
    bool hasCrawled_ = false;
};

}  // namespace oroforge::messages

#endif
