// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What generated code says about the components of a library, for use before one of them is created.
#ifndef ORO_INTERNAL_COMPONENT_DESCRIPTION_HPP
#define ORO_INTERNAL_COMPONENT_DESCRIPTION_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <string>
#include <typeinfo>

namespace RTT {
namespace internal {

/** A table in constant memory, or none. */
template <class T>
struct DescribedList {
    constexpr DescribedList() = default;
    template <std::size_t N>
    constexpr DescribedList(const T (&table)[N]) : first(table), count(N) {}

    const T* begin() const { return first; }
    const T* end() const { return first + count; }

    const T* first = nullptr;
    std::size_t count = 0;
};

struct DescribedPort {
    const char* name; /**< of a service: `service.port` */
    const std::type_info* type;
    bool output;
};

struct DescribedProperty {
    const char* name; /**< of a service: `service.property` */
    const std::type_info* type;
};

/** What the manifest says. The class's own code may add more. */
struct ComponentDescription {
    const char* type; /**< as in ORO_CREATE_COMPONENT or ORO_LIST_COMPONENT_TYPE */
    const char* package;
    DescribedList<DescribedPort> ports;
    DescribedList<DescribedProperty> properties;
    bool dynamic; /**< the manifest says that ports or properties are added at run time */
};

/**
 * A static object of this type registers a table as long as the library that contains it is loaded. Allocates nothing.
 */
class RTT_API ComponentDescriptions {
public:
    explicit ComponentDescriptions(DescribedList<ComponentDescription> table);
    ~ComponentDescriptions();
    ComponentDescriptions(const ComponentDescriptions&) = delete;
    ComponentDescriptions& operator=(const ComponentDescriptions&) = delete;

    /**
     * The description of a component type from the library or program that contains `code`. Several libraries may have
     * a type of one name; the function that creates it tells them apart. Null if there is none. Valid until the library
     * is unloaded. Any thread; not real-time: waits for threads that open libraries.
     */
    static const ComponentDescription* find(const std::string& type, const void* code);

private:
    const DescribedList<ComponentDescription> table_;
    const void* const library_;  // its load address
    ComponentDescriptions* next_ = nullptr;
};

}  // namespace internal
}  // namespace RTT

#endif
