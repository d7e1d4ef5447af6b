// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "component_table.hpp"

#include <rtt/Logger.hpp>
#include <rtt/plugin/detail/search_path.hpp>

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <utility>

namespace RTT::plugin {

ComponentTable::LoadResult ComponentTable::loadLibrary(const std::string& file) {
    const std::string path = canonicalPath(file);
    const auto isSame = [&](const ComponentLibrary& known) { return known.path == path; };
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (std::any_of(libraries_.begin(), libraries_.end(), isSame)) return {};
    }
    ComponentLibrary library;
    LoadResult result;
    const LibraryState state = openComponentLibrary(path, library, result.error);
    if (state != LibraryState::Opened) {
        result.noComponents = state == LibraryState::NoComponents;
        return result;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    // Another thread may have been as far with the same file; the linker counts, so dropping ours is enough.
    if (std::none_of(libraries_.begin(), libraries_.end(), isSame)) {
        registerTypes(library);
        libraries_.push_back(std::move(library));
    }
    return {};
}

void ComponentTable::registerTypes(ComponentLibrary& library) {
    for (const auto& type : library.types) {
        const Type known = findType(type.first);
        if (!known.create) {
            types_[type.first] = Type{type.second, library.path};
            log(Info) << "component type '" << type.first << "' from " << library.path << endlog();
        } else {
            log(Info) << "component type '" << type.first << "' of " << library.path
                      << " is not used: " << (known.library.empty() ? std::string("the program") : known.library)
                      << " already has it" << endlog();
        }
    }
}

std::string ComponentTable::reloadLibrary(const std::string& file) {
    const std::string path = canonicalPath(file);
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto known = std::find_if(libraries_.begin(), libraries_.end(),
                                        [&](const ComponentLibrary& library) { return library.path == path; });
        if (known == libraries_.end()) return "it is not loaded";
        for (const Component& component : components_)
            if (component.library == path)
                return "component '" + component.name + "' was created from it and still exists";
        for (auto type = types_.begin(); type != types_.end();)
            type = type->second.library == path ? types_.erase(type) : std::next(type);
        libraries_.erase(known);
    }
    return loadLibrary(path).error;
}

void ComponentTable::addFactory(const std::string& type, ComponentLoaderSignature create) {
    const std::lock_guard<std::mutex> lock(mutex_);
    types_[type] = Type{create, std::string()};
}

void ComponentTable::addPackage(const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    packages_.insert(name);
}

bool ComponentTable::isImported(const std::string& name) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return findType(name).create || packages_.count(name) != 0;
}

ComponentTable::Type ComponentTable::findType(const std::string& type) const {
    const auto known = types_.find(type);
    if (known != types_.end()) return known->second;
    const FactoryMap& linked = ComponentFactories::Instance();
    const auto own = linked.find(type);
    return own == linked.end() ? Type{nullptr, std::string()} : Type{own->second, std::string()};
}

FactoryMap ComponentTable::factories() const {
    FactoryMap all = ComponentFactories::Instance();
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& type : types_) all[type.first] = type.second.create;
    return all;
}

std::vector<std::string> ComponentTable::components() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> names;
    for (const Component& component : components_)
        if (component.instance) names.push_back(component.name);
    return names;
}

ComponentLoaderSignature ComponentTable::reserve(const std::string& name, const std::string& type, std::string& error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Type known = findType(type);
    if (!known.create) {
        std::vector<std::string> names;
        for (const auto& candidate : types_) names.push_back(candidate.first);
        error = "unknown component type '" + type + "'" + oroforge::diag::didYouMean(type, names);
        return nullptr;
    }
    for (const Component& component : components_)
        if (component.name == name) {
            error = "a component of that name is already loaded";
            return nullptr;
        }
    components_.push_back(Component{name, nullptr, known.library});
    return known.create;
}

void ComponentTable::settle(const std::string& name, TaskContext* component) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto reserved = std::find_if(components_.begin(), components_.end(), [&](const Component& candidate) {
        return candidate.name == name && !candidate.instance;
    });
    if (reserved == components_.end()) return;
    if (component)
        reserved->instance = component;
    else
        components_.erase(reserved);
}

bool ComponentTable::owns(const TaskContext* component) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::any_of(components_.begin(), components_.end(),
                       [&](const Component& candidate) { return candidate.instance == component; });
}

void ComponentTable::forget(const TaskContext* component) {
    const std::lock_guard<std::mutex> lock(mutex_);
    components_.erase(std::remove_if(components_.begin(), components_.end(),
                                     [&](const Component& candidate) { return candidate.instance == component; }),
                      components_.end());
}

}  // namespace RTT::plugin
