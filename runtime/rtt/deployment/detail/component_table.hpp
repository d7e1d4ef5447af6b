// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the component loader knows: libraries, component types, packages and the components that exist.
#ifndef OROFORGE_COMPONENT_TABLE_HPP
#define OROFORGE_COMPONENT_TABLE_HPP

#include "component_library.hpp"

#include <map>
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

    LoadResult loadLibrary(const std::string& file);
    /** Empty on success, else the reason. */
    std::string reloadLibrary(const std::string& file);
    void addFactory(const std::string& type, ComponentLoaderSignature create);
    void addPackage(const std::string& name);

    bool isImported(const std::string& name) const;
    FactoryMap factories() const;
    std::vector<std::string> components() const;

    /** How to create the type, the name now taken; null with the reason if one of both cannot be had. */
    ComponentLoaderSignature reserve(const std::string& name, const std::string& type, std::string& error);
    /** Ends what reserve began; a null component gives the name back. */
    void settle(const std::string& name, TaskContext* component);
    bool owns(const TaskContext* component) const;
    void forget(const TaskContext* component);

private:
    struct Type {
        ComponentLoaderSignature create;
        std::string library;  // canonical path; empty: the program itself or added by hand
    };
    struct Component {
        std::string name;
        TaskContext* instance;  // null while the constructor runs
        std::string library;
    };

    void registerTypes(ComponentLibrary& library);
    /** The type, be it of a library or linked into the program; a null function if unknown. */
    Type findType(const std::string& type) const;

    // Guards all below; never held while libraries are opened or components constructed.
    mutable std::mutex mutex_;
    std::map<std::string, Type> types_;
    std::vector<ComponentLibrary> libraries_;
    std::set<std::string> packages_;
    std::vector<Component> components_;
};

}  // namespace RTT::plugin

#endif
