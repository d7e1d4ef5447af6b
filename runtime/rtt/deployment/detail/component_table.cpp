// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "component_table.hpp"

#include <rtt/Logger.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/plugin/search_path.hpp>

#include <diag/type_match.hpp>

#include <algorithm>
#include <utility>

namespace RTT::plugin {
namespace {

FactoryMap functionsOf(const ComponentTypes& types) {
    FactoryMap functions;
    for (const auto& type : types) functions[type.first] = type.second.create;
    return functions;
}

}  // namespace

ComponentTable::~ComponentTable() {
    for (ComponentLibrary& library : libraries_) library.library.keep();
}

/** Marks a library as being opened or closed while this exists. */
class ComponentTable::Busy {
public:
    Busy(ComponentTable& table, const std::string& path) : table_(table) {
        const std::lock_guard<std::mutex> lock(table_.mutex_);
        entry_ = table_.busy_.insert(path);
    }
    ~Busy() {
        const std::lock_guard<std::mutex> lock(table_.mutex_);
        table_.busy_.erase(entry_);
    }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

private:
    ComponentTable& table_;
    std::multiset<std::string>::iterator entry_;
};

ComponentTable::LoadResult ComponentTable::loadLibrary(const std::string& file) {
    const std::string path = canonicalPath(file);
    const auto isSame = [&](const ComponentLibrary& known) { return known.path == path; };
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (std::any_of(libraries_.begin(), libraries_.end(), isSame)) return {};
    }
    const Busy busy(*this, path);
    ComponentLibrary library;
    LoadResult result;
    const LibraryState state = openComponentLibrary(path, library, result.error);
    if (state != LibraryState::Opened) {
        result.noComponents = state == LibraryState::NoComponents;
        return result;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    // Another thread may have loaded the same file meanwhile. The linker counts references, so this one may be dropped.
    if (std::none_of(libraries_.begin(), libraries_.end(), isSame)) {
        registerTypes(library);
        libraries_.push_back(std::move(library));
    }
    return {};
}

void ComponentTable::loadLinked() {
    for (const std::string& file : SharedLibrary::linkedThatDefine({"createComponent", "getComponentFactoryMap"})) {
        const std::string error = loadLibrary(file).error;
        if (!error.empty()) log(Error) << "linked component library " << file << ": " << error << endlog();
    }
}

void ComponentTable::registerTypes(ComponentLibrary& library) {
    for (const auto& type : library.types) {
        const ComponentType known = findType(type.first);
        if (!known.create || known.create == type.second) {
            types_[type.first] = ComponentType{type.second, library.path};
            log(Info) << "component type '" << type.first << "' from " << library.path << endlog();
        } else {
            log(Info) << "component type '" << type.first << "' of " << library.path
                      << " is not used: " << (known.library.empty() ? std::string("the program") : known.library)
                      << " already has it" << endlog();
        }
    }
}

std::string ComponentTable::close(const std::string& path) {
    const Busy busy(*this, path);
    ComponentLibrary closing;
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
        closing = std::move(*known);
        libraries_.erase(known);
    }
    // Connections of its components may still wait to be destroyed by code of the library.
    internal::Reclaimer::synchronize();
    internal::Reclaimer::collect();
    return {};
}

void ComponentTable::forgetPackagesWith(const std::string& path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto holdsIt = [&](const Package& package) {
        return std::count(package.libraries.begin(), package.libraries.end(), path) != 0;
    };
    packages_.erase(std::remove_if(packages_.begin(), packages_.end(), holdsIt), packages_.end());
}

std::string ComponentTable::unloadLibrary(const std::string& file) {
    const std::string path = canonicalPath(file);
    const std::string error = close(path);
    if (error.empty()) forgetPackagesWith(path);
    return error;
}

std::string ComponentTable::reloadLibrary(const std::string& file) {
    const std::string path = canonicalPath(file);
    std::string error = close(path);
    if (!error.empty()) return error;
    const bool stayed = SharedLibrary::isLoaded(path);
    error = loadLibrary(path).error;
    if (!error.empty())
        forgetPackagesWith(path);
    else if (stayed)
        error =
            "the process has not let go of it: another library links it, or it was compiled without -fno-gnu-unique";
    return error;
}

void ComponentTable::addFactory(const std::string& type, ComponentLoaderSignature create) {
    const std::string library = libraryWith(create);
    const std::lock_guard<std::mutex> lock(mutex_);
    types_[type] = ComponentType{create, library};
}

void ComponentTable::addPackage(const std::string& name, const std::vector<std::string>& libraries) {
    const std::lock_guard<std::mutex> lock(mutex_);
    packages_.push_back(Package{name, libraries});
}

bool ComponentTable::isImported(const std::string& name) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return findType(name).create || std::any_of(packages_.begin(), packages_.end(),
                                                [&](const Package& package) { return package.name == name; });
}

ComponentType ComponentTable::findType(const std::string& type) const {
    const auto own = types_.find(type);
    if (own != types_.end()) return own->second;
    for (const auto& [name, registered] : registeredTypes())
        if (name == type && busy_.count(registered.library) == 0) return registered;
    return {nullptr, std::string()};
}

ComponentTypes ComponentTable::allTypes() const {
    ComponentTypes all = types_;
    for (const auto& type : registeredTypes())
        if (busy_.count(type.second.library) == 0) all.insert(type);
    return all;
}

FactoryMap ComponentTable::factories() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return functionsOf(allTypes());
}

const FactoryMap& ComponentTable::keptFactories() {
    const std::lock_guard<std::mutex> lock(mutex_);
    FactoryMap now = functionsOf(allTypes());
    if (kept_.empty() || *kept_.back() != now) kept_.push_back(std::make_unique<const FactoryMap>(std::move(now)));
    return *kept_.back();
}

std::vector<std::string> ComponentTable::typesOf(const std::string& library) const {
    const std::string path = canonicalPath(library);
    std::vector<std::string> names;
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [name, type] : types_)
        if (type.library == path) names.push_back(name);
    return names;
}

std::vector<std::string> ComponentTable::components() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> names;
    for (const Component& component : components_)
        if (component.instance && !component.ending) names.push_back(component.name);
    return names;
}

ComponentLoaderSignature ComponentTable::reserve(const std::string& name, const std::string& type, std::string& error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const ComponentType known = findType(type);
    if (!known.create) {
        std::vector<std::string> names;
        for (const auto& candidate : allTypes()) names.push_back(candidate.first);
        const std::string proposal = oroforge::diag::didYouMeanType(type, names);
        error = "unknown component type '" + type + "'" +
                (proposal.empty() ? "; import the package that has it first" : proposal);
        return nullptr;
    }
    for (const Component& component : components_)
        if (component.name == name) {
            error = "a component of that name is already loaded";
            return nullptr;
        }
    components_.push_back(Component{name, nullptr, known.library, false});
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

bool ComponentTable::claim(const TaskContext* component) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (Component& candidate : components_)
        if (candidate.instance == component && !candidate.ending) return candidate.ending = true;
    return false;
}

void ComponentTable::forget(const TaskContext* component) {
    const std::lock_guard<std::mutex> lock(mutex_);
    components_.erase(
        std::remove_if(components_.begin(), components_.end(),
                       [&](const Component& candidate) { return candidate.ending && candidate.instance == component; }),
        components_.end());
}

}  // namespace RTT::plugin
