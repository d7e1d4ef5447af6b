// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Libraries that a plugin or component library is linked with, and that the linker does not find.
#ifndef OROFORGE_PLUGIN_NEEDED_LIBRARY_HPP
#define OROFORGE_PLUGIN_NEEDED_LIBRARY_HPP

#include <string>

namespace RTT::plugin {

/** The library that the linker did not find, if that is what its text says; else empty. `file` is what it was to open. */
std::string notFoundLibrary(const std::string& linkerText, const std::string& file);

/**
 * Loads the library of that file name from a package on the plugin loader's search path, or from the folder `lib` that a search
 * directory is in: typekits and plugins as their import would. On failure `error` names the library and its package. It is
 * trusted as little as any other (trusted_file.hpp).
 */
bool loadNeeded(const std::string& library, std::string& error);

}  // namespace RTT::plugin

#endif
