// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MARSHALL_INTERFACE_HPP
#define ORO_MARSHALL_INTERFACE_HPP

#include <rtt/PropertyBag.hpp>

namespace RTT {
namespace marsh {

/** Writes properties in some format. Not thread safe, not real-time safe. */
class RTT_API MarshallInterface {
public:
    // Defined here, so that derived classes need not link the marshalling plugin.
    virtual ~MarshallInterface() = default;
    virtual void serialize(base::PropertyBase* property) = 0;
    virtual void serialize(const PropertyBag& bag) = 0;
    /** Finishes what was serialized so far. */
    virtual void flush() = 0;
};

/** Reads properties in some format. */
class RTT_API DemarshallInterface {
public:
    virtual ~DemarshallInterface() = default;
    /** Adds the properties that it reads; the bag owns them. False unless all could be read. */
    virtual bool deserialize(PropertyBag& bag) = 0;
};

}  // namespace marsh
}  // namespace RTT

#endif
