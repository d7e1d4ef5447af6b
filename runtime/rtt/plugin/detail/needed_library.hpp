// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds libraries that a plugin or component library is linked with and that the dynamic linker does not find.
#ifndef OROFORGE_PLUGIN_NEEDED_LIBRARY_HPP
#define OROFORGE_PLUGIN_NEEDED_LIBRARY_HPP

#include <string>

namespace RTT::plugin {

/** The library that the linker says it did not find when it opened `file`; empty if its text says something else. */
std::string notFoundLibrary(const std::string& linkerText, const std::string& file);

/**
 * Loads the library with that file name from a package on the plugin loader's search path, or from the folder `lib`
 * around a search directory. Typekits and plugins are loaded as an import would. On failure `error` names the library
 * and its package. The library must be trusted, as any other (trusted_file.hpp).
 */
bool loadNeeded(const std::string& library, std::string& error);

}  // namespace RTT::plugin

#endif
