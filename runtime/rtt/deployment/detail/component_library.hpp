// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Opens a component library and asks it for its component types.
#ifndef OROFORGE_COMPONENT_LIBRARY_HPP
#define OROFORGE_COMPONENT_LIBRARY_HPP

#include <rtt/Component.hpp>
#include <rtt/plugin/shared_library.hpp>

#include <string>

namespace RTT::plugin {

struct ComponentLibrary {
    std::string path;  // canonical path
    SharedLibrary library;
    FactoryMap types;
};

enum class LibraryState {
    Opened,
    NotLoadable,   // the linker refused; `error` says why
    NoComponents,  // it is some other library
};

/** Opens a file and asks it for its component types. */
LibraryState openComponentLibrary(const std::string& file, ComponentLibrary& result, std::string& error);

}  // namespace RTT::plugin

#endif
