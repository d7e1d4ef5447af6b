// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Component.hpp>

#include <rtt/plugin/search_path.hpp>
#include <rtt/plugin/shared_library.hpp>
#include "detail/registered_types.hpp"

#include <map>
#include <mutex>

namespace RTT {
namespace {

std::mutex& factoriesMutex() {
    static std::mutex mutex;
    return mutex;
}

/** The library of each function, looked up when it is added: later, that would wait for threads that open libraries. */
std::map<ComponentLoaderSignature, std::string>& libraries() {
    static auto* const files = new std::map<ComponentLoaderSignature, std::string>;  // lives as long as the types
    return *files;
}

}  // namespace

std::string plugin::libraryWith(ComponentLoaderSignature create) {
    return canonicalPath(SharedLibrary::fileWith(reinterpret_cast<const void*>(create)));
}

plugin::ComponentTypes plugin::registeredTypes() {
    const std::lock_guard<std::mutex> lock(factoriesMutex());
    ComponentTypes types;
    for (const auto& type : ComponentFactories::Instance()) {
        const auto file = libraries().find(type.second);
        types[type.first] = {type.second, file == libraries().end() ? std::string() : file->second};
    }
    return types;
}

FactoryMap& ComponentFactories::Instance() {
    // Never destroyed: static objects of libraries remove themselves from it when the process ends.
    static FactoryMap* const types = new FactoryMap;
    return *types;
}

void ComponentFactories::add(const std::string& type_name, ComponentLoaderSignature create) {
    const std::string library = plugin::libraryWith(create);
    const std::lock_guard<std::mutex> lock(factoriesMutex());
    Instance()[type_name] = create;
    libraries()[create] = library;
}

void ComponentFactories::remove(const std::string& type_name, ComponentLoaderSignature create) {
    const std::lock_guard<std::mutex> lock(factoriesMutex());
    const auto known = Instance().find(type_name);
    if (known != Instance().end() && known->second == create) Instance().erase(known);
    libraries().erase(create);
}

FactoryMap ComponentFactories::all() {
    const std::lock_guard<std::mutex> lock(factoriesMutex());
    return Instance();
}

void ComponentFactories::add(FactoryMap& types, const std::string& type_name, ComponentLoaderSignature create) {
    types[type_name] = create;
}

}  // namespace RTT
