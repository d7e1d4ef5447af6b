// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_NEWER_PROPERTIES_HPP
#define ORO_NEWER_PROPERTIES_HPP

#include <rtt/rtt-config.h>

#include <string>
#include <vector>

namespace RTT {
class PropertyBag;

namespace internal {

/**
 * Names of properties that a component has got since its users wrote their files: a file that must have all properties
 * is complete without them, and they keep their values. Names that the component does not have do no harm. A member of
 * the component, one for each bag.
 */
class RTT_API NewerProperties {
public:
    NewerProperties(const PropertyBag& all, std::vector<std::string> names);
    ~NewerProperties();
    NewerProperties(const NewerProperties&) = delete;
    NewerProperties& operator=(const NewerProperties&) = delete;

    /** Any thread. */
    static bool has(const PropertyBag& all, const std::string& name);

private:
    const PropertyBag* const all_;
};

}  // namespace internal
}  // namespace RTT

#endif
