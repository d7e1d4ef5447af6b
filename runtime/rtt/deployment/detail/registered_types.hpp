// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Component types that are registered, and their libraries.
#ifndef OROFORGE_REGISTERED_TYPES_HPP
#define OROFORGE_REGISTERED_TYPES_HPP

#include <rtt/Component.hpp>

#include <map>
#include <string>

namespace RTT::plugin {

struct ComponentType {
    ComponentLoaderSignature create;
    std::string library;  // canonical path of the library or program; empty if unknown
};
typedef std::map<std::string, ComponentType> ComponentTypes;

/** The `library` of a type that the function creates. Waits for threads that open libraries. */
std::string libraryWith(ComponentLoaderSignature create);

/** The types in ComponentFactories. Thread-safe; does not wait for threads that open libraries. */
ComponentTypes registeredTypes();

}  // namespace RTT::plugin

#endif
