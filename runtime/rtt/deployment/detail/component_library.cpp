// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "component_library.hpp"

#include <rtt/plugin/search_path.hpp>

#include <exception>

namespace RTT::plugin {
namespace {

/** Adds the types that the library exports in one of two forms; false if it exports neither. */
bool collectExported(ComponentLibrary& result) {
    auto* typesOf = result.library.function<FactoryMap*()>("getComponentFactoryMap");
    if (typesOf)
        if (const FactoryMap* types = typesOf()) result.types = *types;
    auto* create = result.library.function<TaskContext*(std::string)>("createComponent");
    auto* typeName = result.library.function<std::string()>("getComponentType");
    if (create && typeName) result.types[typeName()] = create;
    return typesOf || (create && typeName);
}

/** Adds the types that its static objects registered, as in libraries compiled without RTT_COMPONENT. */
void collectRegistered(ComponentLibrary& result) {
    for (const auto& type : ComponentFactories::all())
        if (result.library.holds(reinterpret_cast<const void*>(type.second))) result.types.insert(type);
}

}  // namespace

LibraryState openComponentLibrary(const std::string& file, ComponentLibrary& result, std::string& error) {
    result.path = canonicalPath(file);
    result.types.clear();
    try {
        // Static objects of the library run here and may throw.
        result.library = SharedLibrary(result.path, SharedLibrary::Local, error);
        if (!result.library) return LibraryState::NotLoadable;
        if (const std::string version = result.library.otherVersion(); !version.empty()) {
            error = "it is built for " + version + ", this program for " ORO_BUILT_FOR;
            return LibraryState::NotLoadable;
        }
        const bool exports = collectExported(result);
        collectRegistered(result);
        if (exports || !result.types.empty()) return LibraryState::Opened;
        error =
            "it exports neither createComponent nor getComponentFactoryMap; "
            "put ORO_CREATE_COMPONENT or ORO_CREATE_COMPONENT_LIBRARY into it and define RTT_COMPONENT";
        return LibraryState::NoComponents;
    } catch (const std::exception& thrown) {
        error = thrown.what();
    } catch (...) {
        error = "unknown exception while loading";
    }
    return LibraryState::NotLoadable;
}

}  // namespace RTT::plugin
