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

template <class Types>
std::vector<std::string> namesIn(const Types& types) {
    std::vector<std::string> names;
    for (const auto& type : types) names.push_back(type.first);
    return names;
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
    // The first library with a type has it, also if it only waits.
    (void)loadDeferredWith(namesIn(library.types), path);
    const std::lock_guard<std::mutex> lock(mutex_);
    deferred_.remove(path);
    // Another thread may have loaded the same file meanwhile. The linker counts references, so this one may be dropped.
    if (std::none_of(libraries_.begin(), libraries_.end(), isSame)) {
        registerTypes(library);
        libraries_.push_back(std::move(library));
    }
    return {};
}

void ComponentTable::defer(const std::string& file, std::vector<std::string> types) {
    const std::string path = canonicalPath(file);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::any_of(libraries_.begin(), libraries_.end(),
                    [&](const ComponentLibrary& known) { return known.path == path; }))
        return;
    log(Info) << "component types of " << path << ", which is loaded when one is needed:";
    for (const std::string& type : types) log() << " '" << type << "'";
    log() << endlog();
    deferred_.add(path, std::move(types));
}

std::string ComponentTable::loadDeferred(const std::string& path) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!deferred_.has(path)) return {};
    }
    const std::string error = loadLibrary(path).error;
    if (error.empty()) return {};
    log(Info) << "could not load component library '" << path << "': " << error << endlog();
    const std::lock_guard<std::mutex> lock(mutex_);
    deferred_.markFailed(path);
    return path + ": " + error;
}

std::string ComponentTable::loadDeferredWith(const std::vector<std::string>& types, const std::string& before) {
    std::vector<std::string> paths;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        paths = deferred_.with(types, before);
    }
    std::string errors;
    for (const std::string& path : paths)
        if (const std::string error = loadDeferred(path); !error.empty())
            errors += (errors.empty() ? "" : "; ") + error;
    return errors;
}

std::vector<std::string> ComponentTable::loadDeferredOf(const std::string& package) {
    std::vector<std::string> paths, errors;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (const Package& known : packages_)
            if (known.name == package) paths = known.libraries;
    }
    for (const std::string& path : paths)
        if (std::string error = loadDeferred(path); !error.empty()) errors.push_back(std::move(error));
    return errors;
}

std::string ComponentTable::loadDeferredFor(const std::string& type) {
    const std::string problem = loadDeferredWith({type});
    if (problem.empty() && !isImported(type)) loadAllDeferred();  // one may have types that it does not list
    return problem;
}

void ComponentTable::loadAllDeferred() {
    DeferredLibraries waiting;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        waiting = deferred_;
    }
    for (const DeferredLibraries::Library& library : waiting.all())
        if (!library.failed) (void)loadDeferred(library.path);
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
        if (deferred_.remove(path)) return {};
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
    return findType(name).create || deferred_.hasType(name) ||
           std::any_of(packages_.begin(), packages_.end(),
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

std::vector<std::string> ComponentTable::typeNames() {
    loadAllDeferred();
    const std::lock_guard<std::mutex> lock(mutex_);
    return namesIn(allTypes());
}

ComponentLoaderSignature ComponentTable::factoryOf(const std::string& type) {
    (void)loadDeferredFor(type);
    const std::lock_guard<std::mutex> lock(mutex_);
    return findType(type).create;
}

const FactoryMap& ComponentTable::keptFactories() {
    loadAllDeferred();
    const std::lock_guard<std::mutex> lock(mutex_);
    FactoryMap now = functionsOf(allTypes());
    if (kept_.empty() || *kept_.back() != now) kept_.push_back(std::make_unique<const FactoryMap>(std::move(now)));
    return *kept_.back();
}

std::vector<std::string> ComponentTable::typesOf(const std::string& library) {
    const std::string path = canonicalPath(library);
    (void)loadDeferred(path);
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
    const std::string problem = loadDeferredFor(type);
    const std::lock_guard<std::mutex> lock(mutex_);
    const ComponentType known = findType(type);
    if (!known.create && !problem.empty()) {
        error = "the library of component type '" + type + "' cannot be loaded: " + problem;
        return nullptr;
    }
    if (!known.create) {
        const std::string proposal = oroforge::diag::didYouMeanType(type, namesIn(allTypes()));
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
