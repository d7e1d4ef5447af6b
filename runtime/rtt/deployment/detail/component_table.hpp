// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The state of the component loader: libraries, component types, packages and existing components.
#ifndef OROFORGE_COMPONENT_TABLE_HPP
#define OROFORGE_COMPONENT_TABLE_HPP

#include "component_library.hpp"
#include "deferred_libraries.hpp"
#include "registered_types.hpp"

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace RTT::plugin {

class ComponentTable {
public:
    struct LoadResult {
        std::string error;          // empty: the library is loaded
        bool noComponents = false;  // because it is some other library
    };

    ComponentTable() = default;
    /** Leaves all libraries loaded: components and their connections may outlive the table. */
    ~ComponentTable();

    LoadResult loadLibrary(const std::string& file);
    /** Loads the library when one of these types, or all that there is, is asked for. */
    void defer(const std::string& file, std::vector<std::string> types);
    /** Loads those libraries of the package that wait; "file: reason" for each that cannot be loaded. */
    std::vector<std::string> loadDeferredOf(const std::string& package);
    /** Registers the types of component libraries that the program is linked with. */
    void loadLinked();
    /** Empty on success, else the reason. */
    std::string unloadLibrary(const std::string& file);
    std::string reloadLibrary(const std::string& file);
    void addFactory(const std::string& type, ComponentLoaderSignature create);
    /** Remembers that the package is imported, until one of these library files is unloaded. */
    void addPackage(const std::string& name, const std::vector<std::string>& libraries);

    bool isImported(const std::string& name) const;
    /** The names of all types, sorted. Loads libraries that wait. */
    std::vector<std::string> typeNames();
    /** The function that creates the type; null if it is unknown or its library cannot be loaded. */
    ComponentLoaderSignature factoryOf(const std::string& type);
    /** All types. Loads libraries that wait. Valid as long as this table. */
    const FactoryMap& keptFactories();
    std::vector<std::string> components() const;
    /** The types that come from this library file. Loads it if it waits. */
    std::vector<std::string> typesOf(const std::string& library);

    /** Reserves the name and returns the function that creates the type; null with the reason if either is
        unavailable. */
    ComponentLoaderSignature reserve(const std::string& name, const std::string& type, std::string& error);
    /** Completes reserve() with the component; null gives the name back. */
    void settle(const std::string& name, TaskContext* component);
    /** True for the one caller that must delete the component and then call forget(). False for a component not in this
        table. */
    bool claim(const TaskContext* component);
    void forget(const TaskContext* component);

private:
    struct Component {
        std::string name;
        TaskContext* instance;  // null while the constructor runs
        std::string library;
        bool ending = false;  // being deleted
    };
    struct Package {
        std::string name;
        std::vector<std::string> libraries;  // canonical paths
    };

    class Busy;

    std::string close(const std::string& path);
    /** Loads a library that waits; the reason if that fails. */
    std::string loadDeferred(const std::string& path);
    /** Loads those that wait and have one of the types, up to the library `before`; the reason if one cannot be
        loaded. */
    std::string loadDeferredWith(const std::vector<std::string>& types, const std::string& before = std::string());
    /** Loads what may have the type; the reason if that fails. */
    std::string loadDeferredFor(const std::string& type);
    void loadAllDeferred();
    void forgetPackagesWith(const std::string& path);
    // These are called with the lock held.
    void registerTypes(ComponentLibrary& library);
    /** The type, from a library or registered by a static object; a null function if unknown. */
    ComponentType findType(const std::string& type) const;
    /** All types except those registered only by static objects of busy libraries, which may vanish at any moment. */
    ComponentTypes allTypes() const;

    // Guards all below; never held while libraries are opened or components constructed.
    mutable std::mutex mutex_;
    ComponentTypes types_;
    std::vector<ComponentLibrary> libraries_;
    DeferredLibraries deferred_;
    std::vector<Package> packages_;
    std::vector<Component> components_;
    std::multiset<std::string> busy_;  // canonical paths of libraries that are being opened or closed
    std::vector<std::unique_ptr<const FactoryMap>> kept_;
};

}  // namespace RTT::plugin

#endif
