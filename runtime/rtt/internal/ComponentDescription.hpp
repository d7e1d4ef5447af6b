// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What generated code tells of the components of a library, for those who want to know before they make one.
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

/** What the manifest says. The class may have more: what its own code adds. */
struct ComponentDescription {
    const char* type; /**< as in ORO_CREATE_COMPONENT or ORO_LIST_COMPONENT_TYPE */
    const char* package;
    DescribedList<DescribedPort> ports;
    DescribedList<DescribedProperty> properties;
    bool dynamic; /**< the manifest says that ports or properties are added at run time */
};

/**
 * A static object of this type makes a table known as long as it exists: while the library is loaded that it is compiled
 * into. Neither it nor the table allocates.
 */
class RTT_API ComponentDescriptions {
public:
    explicit ComponentDescriptions(DescribedList<ComponentDescription> table);
    ~ComponentDescriptions();
    ComponentDescriptions(const ComponentDescriptions&) = delete;
    ComponentDescriptions& operator=(const ComponentDescriptions&) = delete;

    /**
     * The description of a component type by the library, or the program, that also holds `code`: several libraries may
     * have a type of one name, and how it is created tells which is meant. Null if there is none. It is there until the
     * library is unloaded. Any thread; not real-time: waits for threads that open libraries.
     */
    static const ComponentDescription* find(const std::string& type, const void* code);

private:
    const DescribedList<ComponentDescription> table_;
    const void* const library_;  // where it begins in memory
    ComponentDescriptions* next_ = nullptr;
};

}  // namespace internal
}  // namespace RTT

#endif
