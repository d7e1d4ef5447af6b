// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_DECOMPOSITION_HPP
#define ORO_PROPERTY_DECOMPOSITION_HPP

#include <rtt/PropertyBag.hpp>

namespace RTT {
namespace types {

/**
 * Adds the members of a value to `target` and sets the target's type. The properties refer to the value if it can be
 * changed. With `recurse`, members with members become bags. False if the value has no members.
 */
RTT_API bool typeDecomposition(base::DataSourceBase::shared_ptr source, PropertyBag& target, bool recurse = true);
/** The same for the value of a property. */
RTT_API bool propertyDecomposition(base::PropertyBase* source, PropertyBag& target, bool recurse = false);
/** The same for each item of a bag: what has members becomes a bag, the others are copied. False, and nothing is added,
    if `target` has a property of one of these names. */
RTT_API bool decomposePropertyBag(const PropertyBag& source, PropertyBag& target);

/**
 * Adds a copy of each item of `source` to `target`; a bag whose type is registered becomes a value of it. Logs errors
 * and returns false for unknown types and for types that cannot be composed from the given members; also, without
 * adding anything, if `target` has a property of one of these names.
 */
RTT_API bool composePropertyBag(const PropertyBag& source, PropertyBag& target);

}  // namespace types
}  // namespace RTT

#endif
