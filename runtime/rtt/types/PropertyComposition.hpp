// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_COMPOSITION_HPP
#define ORO_PROPERTY_COMPOSITION_HPP

#include <rtt/PropertyBag.hpp>
#include <rtt/types/PropertyDecomposition.hpp>  // users get both from here

namespace RTT {
namespace types {

/**
 * Adds a copy of each item of `source` to `target`; a bag whose type is registered becomes a value of it. Logs errors
 * and returns false for unknown types and for types that cannot be composed from the given members; also, without
 * adding anything, if `target` has a property of one of these names.
 */
RTT_API bool composePropertyBag(const PropertyBag& source, PropertyBag& target);

}  // namespace types
}  // namespace RTT

#endif
