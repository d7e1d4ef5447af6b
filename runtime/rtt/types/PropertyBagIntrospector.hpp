// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_BAG_INTROSPECTOR_HPP
#define ORO_PROPERTY_BAG_INTROSPECTOR_HPP

#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/base/PropertyIntrospection.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

namespace RTT {
namespace types {

/**
 * A visitor that collects properties in a bag: `bag.identify(&introspector)`. Values with members become bags, and so
 * do their members; the properties refer to the visited values. Not real-time safe, for one thread at a time.
 */
class PropertyBagIntrospector : public base::PropertyIntrospection {
public:
    /** The bag must outlive this. */
    explicit PropertyBagIntrospector(PropertyBag& target) : target_(target) {}

    using base::PropertyIntrospection::introspect;
    void introspect(base::PropertyBase* property) override {
        if (property) add(*property);
    }
    void introspect(Property<bool>& property) override { add(property); }
    void introspect(Property<char>& property) override { add(property); }
    void introspect(Property<int>& property) override { add(property); }
    void introspect(Property<unsigned int>& property) override { add(property); }
    void introspect(Property<double>& property) override { add(property); }
    void introspect(Property<float>& property) override { add(property); }
    void introspect(Property<std::string>& property) override { add(property); }
    void introspect(Property<PropertyBag>& property) override { add(property); }

private:
    void add(base::PropertyBase& property) {
        PropertyBag one(target_.getType());
        one.add(&property);
        decomposePropertyBag(one, target_);
    }

    PropertyBag& target_;
};

}  // namespace types
}  // namespace RTT

#endif
