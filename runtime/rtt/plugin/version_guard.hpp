// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A function by which a component library or plugin tells the loaders what it was compiled for. Each source file that
// includes the headers of the macros defines it; the linker keeps one per library. Libraries without it are not
// checked.
#ifndef ORO_PLUGIN_VERSION_GUARD_HPP
#define ORO_PLUGIN_VERSION_GUARD_HPP

#include <rtt/rtt-config.h>

#include <string>

// The layout of classes may change with the minor version; that of std::string depends on compiler options.
#if defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
#define ORO_PLUGIN_STRINGS_ " with the old std::string"
#else
#define ORO_PLUGIN_STRINGS_ ""
#endif

/** What this source file is compiled for; the loaders compare and show it. */
#define ORO_BUILT_FOR "RTT " ORO_STRINGIFY(RTT_VERSION_MAJOR) "." ORO_STRINGIFY(RTT_VERSION_MINOR) ORO_PLUGIN_STRINGS_

extern "C" {
RTT_EXPORT const char* getRTTBuiltFor();
__attribute__((weak)) const char* getRTTBuiltFor() { return ORO_BUILT_FOR; }
}

#endif
