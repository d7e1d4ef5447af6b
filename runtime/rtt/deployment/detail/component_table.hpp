// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the component loader knows: libraries, component types, packages and the components that exist.
#ifndef OROFORGE_COMPONENT_TABLE_HPP
#define OROFORGE_COMPONENT_TABLE_HPP

#include "component_library.hpp"
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
        bool noComponents = false;  // the reason is that it is some other library
    };

    ComponentTable() = default;
    /** Leaves all libraries loaded: components and what they connected may live on. */
    ~ComponentTable();

    LoadResult loadLibrary(const std::string& file);
    /** Registers the types of component libraries that the program is linked with. */
    void loadLinked();
    /** Empty on success, else the reason. */
    std::string unloadLibrary(const std::string& file);
    std::string reloadLibrary(const std::string& file);
    void addFactory(const std::string& type, ComponentLoaderSignature create);
    /** Remembers that the package is imported, until one of these library files is unloaded. */
    void addPackage(const std::string& name, const std::vector<std::string>& libraries);

    bool isImported(const std::string& name) const;
    FactoryMap factories() const;
    /** As factories(), kept as long as this table. */
    const FactoryMap& keptFactories();
    std::vector<std::string> components() const;
    /** The types that come from this library file. */
    std::vector<std::string> typesOf(const std::string& library) const;

    /** How to create the type, the name now taken; null with the reason if one of both cannot be had. */
    ComponentLoaderSignature reserve(const std::string& name, const std::string& type, std::string& error);
    /** Ends what reserve began; a null component gives the name back. */
    void settle(const std::string& name, TaskContext* component);
    /** Whoever gets true deletes the component and calls forget() then. False for a component that is not ours. */
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
    void forgetPackagesWith(const std::string& path);
    // These are called with the lock held.
    void registerTypes(ComponentLibrary& library);
    /** The type, be it of a library or registered by a static object; a null function if unknown. */
    ComponentType findType(const std::string& type) const;
    /** All of them, but for those that only static objects of busy libraries registered: these may vanish any moment. */
    ComponentTypes allTypes() const;

    // Guards all below; never held while libraries are opened or components constructed.
    mutable std::mutex mutex_;
    ComponentTypes types_;
    std::vector<ComponentLibrary> libraries_;
    std::vector<Package> packages_;
    std::vector<Component> components_;
    std::multiset<std::string> busy_;  // canonical paths of libraries that are being opened or closed
    std::vector<std::unique_ptr<const FactoryMap>> kept_;
};

}  // namespace RTT::plugin

#endif
