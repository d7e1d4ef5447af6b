// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTYINTROSPECTION_HPP
#define ORO_PROPERTYINTROSPECTION_HPP

#include <rtt/rtt-config.h>
#include <string>

namespace RTT {

class PropertyBag;
template <class T>
class Property;

namespace base {
class PropertyBase;

/** Visitor of properties: one function for each type of property files, one for all others. */
class RTT_API PropertyIntrospection {
public:
    virtual ~PropertyIntrospection();

    /** Called for every type without a function of its own. */
    virtual void introspect(PropertyBase* property) = 0;
    virtual void introspect(Property<bool>& property) = 0;
    virtual void introspect(Property<char>& property) = 0;
    virtual void introspect(Property<int>& property) = 0;
    virtual void introspect(Property<unsigned int>& property) = 0;
    virtual void introspect(Property<double>& property) = 0;
    virtual void introspect(Property<float>& property) = 0;
    virtual void introspect(Property<std::string>& property) = 0;
    virtual void introspect(Property<PropertyBag>& property) = 0;
    // Types that visitors may leave to introspect(PropertyBase*).
    virtual void introspect(Property<unsigned char>& property);
    virtual void introspect(Property<short>& property);
    virtual void introspect(Property<unsigned short>& property);
    virtual void introspect(Property<long long>& property);
    virtual void introspect(Property<unsigned long long>& property);
};

}  // namespace base
}  // namespace RTT

#endif
