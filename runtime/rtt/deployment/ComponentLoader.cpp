// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ComponentLoader.hpp"

#include <rtt/Logger.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/plugin/search_path.hpp>
#include "detail/component_table.hpp"
#include "detail/package_import.hpp"

#include <exception>
#include <mutex>
#include <stdexcept>

namespace RTT {
namespace {

/** How long a component may take to stop before it is destroyed all the same. */
constexpr Seconds kPatience = 2.0;

ComponentLoader::shared_ptr& instance() {
    // Never destroyed: a static object of the program may end the runtime in its destructor.
    static auto* loader = new ComponentLoader::shared_ptr;
    return *loader;
}

std::mutex& instanceMutex() {
    static std::mutex mutex;
    return mutex;
}

/** Runs the user's constructor and turns its exceptions into text. */
TaskContext* construct(ComponentLoaderSignature create, const std::string& name, const std::string& type,
                       std::string& error) {
    const internal::HookInProgress here(name.c_str(), "its constructor");
    try {
        if (TaskContext* component = create(name)) return component;
        error = "the factory of component type '" + type + "' returned nothing";
    } catch (const std::exception& thrown) {
        error = "the constructor of component type '" + type + "' threw: " + thrown.what();
    } catch (...) {
        error = "the constructor of component type '" + type + "' threw an unknown exception";
    }
    return nullptr;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
    return text;
}

/**
 * Logs the errors of an import and throws if libraries were found that cannot be loaded. If none were found, logs that
 * at level `nothingFound`.
 */
bool finish(const plugin::PackageImport& import, const std::string& what, LoggerLevel nothingFound) {
    for (const std::string& error : import.errors())
        log(import.hasBrokenLibraries() ? Error : nothingFound)
            << "could not import '" << what << "': " << error << endlog();
    if (import.hasBrokenLibraries())
        throw std::runtime_error("could not import all of '" + what + "': " + joined(import.errors()));
    return import.errors().empty();
}

/** Returns true if there is no error; otherwise logs why a component library could not be loaded or unloaded. */
bool succeeded(const char* what, const std::string& file, const std::string& error) {
    if (!error.empty())
        log(Error) << "could not " << what << " component library '" << file << "': " << error << endlog();
    return error.empty();
}

}  // namespace

struct ComponentLoader::Impl {
    plugin::ComponentTable table;
    mutable std::mutex pathMutex;
    std::string path = plugin::defaultSearchPath();
};

ComponentLoader::ComponentLoader() : impl_(new Impl) { impl_->table.loadLinked(); }

ComponentLoader::~ComponentLoader() = default;

ComponentLoader::shared_ptr ComponentLoader::Instance() {
    const std::lock_guard<std::mutex> lock(instanceMutex());
    if (!instance()) instance().reset(new ComponentLoader);
    return instance();
}

void ComponentLoader::Release() {
    const std::lock_guard<std::mutex> lock(instanceMutex());
    if (instance() && instance()->listComponents().empty()) instance().reset();
}

bool ComponentLoader::import(const std::string& path_list) {
    const Logger::In in("ComponentLoader");
    plugin::PackageImport import(impl_->table);
    import.directories(plugin::splitPathList(path_list));
    return finish(import, path_list, Info);
}

bool ComponentLoader::import(const std::string& package, const std::string& path_list) {
    const Logger::In in("ComponentLoader");
    plugin::PackageImport import(impl_->table);
    import.package(package, path_list.empty() ? getComponentPath() : path_list);
    return finish(import, package, Error);
}

bool ComponentLoader::import(const std::string& package, const std::string& path_list, std::string& error) {
    const Logger::In in("ComponentLoader");
    plugin::PackageImport import(impl_->table);
    import.package(package, path_list.empty() ? getComponentPath() : path_list);
    error = joined(import.errors());
    return import.errors().empty();
}

bool ComponentLoader::importInstalled(const std::string& package, std::string& error) {
    const Logger::In in("ComponentLoader");
    plugin::PackageImport import(impl_->table);
    import.installed(package, getComponentPath());
    error = joined(import.errors());
    return import.errors().empty();
}

bool ComponentLoader::importRos(const std::string& package, std::string& error) {
    const Logger::In in("ComponentLoader");
    plugin::PackageImport import(impl_->table);
    import.ros(package, getComponentPath());
    error = joined(import.errors());
    return import.errors().empty();
}

bool ComponentLoader::loadLibrary(const std::string& path) {
    const Logger::In in("ComponentLoader");
    return succeeded("load", path, impl_->table.loadLibrary(path).error);
}

bool ComponentLoader::loadLibrary(const std::string& path, std::string& error) {
    error = impl_->table.loadLibrary(path).error;
    return error.empty();
}

bool ComponentLoader::unloadLibrary(const std::string& filepath) {
    const Logger::In in("ComponentLoader");
    return succeeded("unload", filepath, impl_->table.unloadLibrary(filepath));
}

bool ComponentLoader::reloadLibrary(const std::string& filepath) {
    const Logger::In in("ComponentLoader");
    return succeeded("reload", filepath, impl_->table.reloadLibrary(filepath));
}

TaskContext* ComponentLoader::loadComponent(const std::string& name, const std::string& type) {
    const Logger::In in("ComponentLoader");
    std::string error;
    TaskContext* component = loadComponent(name, type, error);
    if (!component) log(Error) << "failed to load component '" << name << "': " << error << endlog();
    return component;
}

TaskContext* ComponentLoader::loadComponent(const std::string& name, const std::string& type, std::string& error) {
    const ComponentLoaderSignature create = impl_->table.reserve(name, type, error);
    if (!create) return nullptr;
    TaskContext* component = construct(create, name, type, error);
    impl_->table.settle(name, component);
    return component;
}

bool ComponentLoader::unloadComponent(TaskContext* tc) {
    const Logger::In in("ComponentLoader");
    if (!tc || !impl_->table.claim(tc)) {
        log(Error) << "refusing to unload a component that this loader did not load" << endlog();
        return false;
    }
    const std::string name = tc->getName();
    const internal::HookInProgress here(name.c_str(), "its destructor");
    // The result does not matter: only the destructor may be able to end an operation that blocks.
    (void)tc->stopForGood(kPatience);
    try {
        delete tc;
    } catch (const std::exception& thrown) {
        log(Error) << "the destructor of component '" << name << "' threw: " << thrown.what() << endlog();
    } catch (...) {
        log(Error) << "the destructor of component '" << name << "' threw an unknown exception" << endlog();
    }
    impl_->table.forget(tc);
    return true;
}

bool ComponentLoader::isImported(const std::string& type_name) const { return impl_->table.isImported(type_name); }
std::vector<std::string> ComponentLoader::listComponents() const { return impl_->table.components(); }

std::vector<std::string> ComponentLoader::listComponentTypes() const { return impl_->table.typeNames(); }

std::vector<std::string> ComponentLoader::listComponentTypes(const std::string& library) const {
    return impl_->table.typesOf(library);
}

std::string ComponentLoader::getComponentPath() const {
    const std::lock_guard<std::mutex> lock(impl_->pathMutex);
    return impl_->path;
}

void ComponentLoader::setComponentPath(const std::string& newpath) {
    const std::lock_guard<std::mutex> lock(impl_->pathMutex);
    impl_->path = newpath;
}

const FactoryMap& ComponentLoader::getFactories() const { return impl_->table.keptFactories(); }

ComponentLoaderSignature ComponentLoader::factoryOf(const std::string& type_name) const {
    const Logger::In in("ComponentLoader");
    return impl_->table.factoryOf(type_name);
}

void ComponentLoader::addFactory(const std::string& type_name, ComponentLoaderSignature factory) {
    impl_->table.addFactory(type_name, factory);
}

}  // namespace RTT
