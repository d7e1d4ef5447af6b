// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Path lists, library names and directories for the plugin loader and the component loader.
#ifndef OROFORGE_PLUGIN_SEARCH_PATH_HPP
#define OROFORGE_PLUGIN_SEARCH_PATH_HPP

#include <string>
#include <vector>

namespace RTT::plugin {

/** The directories of a list separated by ':' or ';', in order, without empty and repeated ones. */
std::vector<std::string> splitPathList(const std::string& list);

/** RTT_COMPONENT_PATH of the environment followed by `orocos` in the directory of the runtime's library. */
std::string defaultSearchPath();

/** The directory and its sub-directory for this target, if they exist. A directory of a target has no such
    sub-directory. */
std::vector<std::string> withTargetDirectory(const std::string& directory);

/** The `*.so` and `*.so.N` files of a directory, sorted by name; empty if it does not exist. */
std::vector<std::string> librariesIn(const std::string& directory);

bool isDirectory(const std::string& path);
bool isFile(const std::string& path);
/** The path with links, `.` and `..` resolved; unchanged if it does not exist. */
std::string canonicalPath(const std::string& path);
/** The path from the root directory; links are not resolved. */
std::string absolutePath(const std::string& path);
/** The last component of a path; a final '/' is ignored. */
std::string fileName(const std::string& path);
/** The path without its last component; "." if nothing remains. */
std::string parentPath(const std::string& path);
/** `robot` for `libs/librobot-gnulinux.so.2`: no directory, no `lib`, no target, no suffix. */
std::string shortName(const std::string& path);
/** The file names that a library with that short name may have. */
std::vector<std::string> fileNamesOf(const std::string& shortName);

}  // namespace RTT::plugin

#endif
