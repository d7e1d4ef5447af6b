// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/**
 * Macros that register component classes with the component loader. Write the class with its namespace; its constructor
 * takes a std::string, the name of the component.
 *
 *     ORO_CREATE_COMPONENT(NS::Class)        // a library with one component type
 *
 *     ORO_CREATE_COMPONENT_LIBRARY()         // a library with several: this once,
 *     ORO_LIST_COMPONENT_TYPE(NS::Class)     // and this per type, in any source file
 *
 * With RTT_COMPONENT defined (orocos_component() does so) the library can be loaded at run time. Without it, or with
 * RTT_STATIC, the types are registered in the program that links the code. A linker takes from a static library only
 * what is referred to, and nothing refers to these: link it as a whole, as orocos_component(name STATIC …) does.
 */
#ifndef ORO_COMPONENT_HPP
#define ORO_COMPONENT_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/plugin/c_linkage.hpp>
#include <rtt/plugin/version_guard.hpp>
#include <rtt/rtt-config.h>

#include <map>
#include <string>
#include <vector>

#if (defined(RTT_COMPONENT) || defined(OCL_DLL_EXPORT)) && !defined(RTT_STATIC) && !defined(OCL_STATIC)
#define ORO_COMPONENT_LIBRARY_
#endif

namespace RTT {

/** Creates a component of one type with the given name. May throw what the constructor throws. */
typedef TaskContext* (*ComponentLoaderSignature)(std::string instance_name);
/** Component types and how to create them. */
typedef std::map<std::string, ComponentLoaderSignature> FactoryMap;

/**
 * The component types of the program itself, or of a library that was not built for the component loader. Static
 * objects register them, before main() or while a library is opened.
 */
class RTT_API ComponentFactories {
public:
    /** The types by name. While other threads may open libraries, use add(), remove() and all(). */
    static FactoryMap& Instance();
    /** Adds or replaces a type. Thread-safe. */
    static void add(const std::string& type_name, ComponentLoaderSignature create);
    /** Removes a type if `create` creates it. Thread-safe. */
    static void remove(const std::string& type_name, ComponentLoaderSignature create);
    /** A snapshot of the types. Thread-safe. */
    static FactoryMap all();

    /** Adds to the types of one library. */
    static void add(FactoryMap& types, const std::string& type_name, ComponentLoaderSignature create);
};

namespace plugin {

/** The types of the library that contains this function; hidden, so that each library has its own. */
RTT_HIDE inline FactoryMap& libraryFactories() {
    static FactoryMap types;
    return types;
}

template <class C>
RTT_HIDE TaskContext* createComponentOf(std::string instance_name) {
    return new C(instance_name);
}

}  // namespace plugin

/** A static object of this type registers a component class under the given name, as long as it exists. */
template <class C>
class RTT_HIDE ComponentFactoryLoader {
public:
#ifdef ORO_COMPONENT_LIBRARY_
    explicit ComponentFactoryLoader(const std::string& type_name) {
        ComponentFactories::add(plugin::libraryFactories(), type_name, &plugin::createComponentOf<C>);
    }
#else
    explicit ComponentFactoryLoader(const std::string& type_name) : type_name_(type_name) {
        ComponentFactories::add(type_name_, &plugin::createComponentOf<C>);
    }
    ~ComponentFactoryLoader() { ComponentFactories::remove(type_name_, &plugin::createComponentOf<C>); }

private:
    std::string type_name_;
#endif
};

}  // namespace RTT

#define ORO_COMPONENT_CONCAT2_(a, b) a##b
#define ORO_COMPONENT_CONCAT_(a, b) ORO_COMPONENT_CONCAT2_(a, b)

#ifdef ORO_COMPONENT_LIBRARY_
/** Writes the name of a type into a section of the library's file, where the loader finds it without opening the
    library. */
#define ORO_COMPONENT_NAME_IN_FILE_(...)                                              \
    namespace {                                                                       \
    __attribute__((section("orocos_types"), used))                                    \
    const char ORO_COMPONENT_CONCAT_(oroComponentType, __COUNTER__)[] = #__VA_ARGS__; \
    }
#else
#define ORO_COMPONENT_NAME_IN_FILE_(...)
#endif

/** Registers one component type of a library or program that has several. */
#define ORO_LIST_COMPONENT_TYPE(...)                                                                 \
    ORO_COMPONENT_NAME_IN_FILE_(__VA_ARGS__)                                                         \
    namespace {                                                                                      \
    const RTT::ComponentFactoryLoader<__VA_ARGS__> ORO_COMPONENT_CONCAT_(oroListedComponent,         \
                                                                         __COUNTER__)(#__VA_ARGS__); \
    }

#ifdef ORO_COMPONENT_LIBRARY_

/** Makes the library one with exactly this component type. Use it once per library. */
#define ORO_CREATE_COMPONENT(...)                                                                                      \
    ORO_COMPONENT_NAME_IN_FILE_(__VA_ARGS__)                                                                           \
    ORO_PLUGIN_C_LINKAGE_BEGIN_                                                                                        \
    RTT_EXPORT RTT::TaskContext* createComponent(std::string instance_name);                                           \
    RTT_EXPORT RTT::TaskContext* createComponent(std::string instance_name) { return new __VA_ARGS__(instance_name); } \
    RTT_EXPORT std::string getComponentType();                                                                         \
    RTT_EXPORT std::string getComponentType() { return #__VA_ARGS__; }                                                 \
    ORO_PLUGIN_C_LINKAGE_END_

/** Makes the library one with the types listed by ORO_LIST_COMPONENT_TYPE. Use it once per library. */
#define ORO_CREATE_COMPONENT_LIBRARY()                                                                   \
    ORO_PLUGIN_C_LINKAGE_BEGIN_                                                                          \
    RTT_EXPORT RTT::TaskContext* createComponentType(std::string instance_name, std::string type_name);  \
    RTT_EXPORT RTT::TaskContext* createComponentType(std::string instance_name, std::string type_name) { \
        const auto found = RTT::plugin::libraryFactories().find(type_name);                              \
        return found == RTT::plugin::libraryFactories().end() ? nullptr : found->second(instance_name);  \
    }                                                                                                    \
    RTT_EXPORT std::vector<std::string> getComponentTypeNames();                                         \
    RTT_EXPORT std::vector<std::string> getComponentTypeNames() {                                        \
        std::vector<std::string> names;                                                                  \
        for (const auto& type : RTT::plugin::libraryFactories()) names.push_back(type.first);            \
        return names;                                                                                    \
    }                                                                                                    \
    RTT_EXPORT RTT::FactoryMap* getComponentFactoryMap();                                                \
    RTT_EXPORT RTT::FactoryMap* getComponentFactoryMap() { return &RTT::plugin::libraryFactories(); }    \
    ORO_PLUGIN_C_LINKAGE_END_

#else

#define ORO_CREATE_COMPONENT(...) ORO_LIST_COMPONENT_TYPE(__VA_ARGS__)
#define ORO_CREATE_COMPONENT_LIBRARY() static_assert(true, "linked into the program: nothing to export");

#endif

/** Old name of ORO_CREATE_COMPONENT_LIBRARY. */
#define ORO_CREATE_COMPONENT_TYPE() ORO_CREATE_COMPONENT_LIBRARY()

#endif
