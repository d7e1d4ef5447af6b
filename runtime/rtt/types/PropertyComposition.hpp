// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_COMPOSITION_HPP
#define ORO_PROPERTY_COMPOSITION_HPP

#include <rtt/PropertyBag.hpp>
#include <rtt/types/PropertyDecomposition.hpp>  // users take both from here

namespace RTT {
namespace types {

/**
 * Adds a copy of each item of `source` to `target`; bags whose type names a registered type become a value of it.
 * False, and errors in the log, for types that are unknown or cannot be composed from the members given; or, with nothing
 * added, if `target` has a property of one of these names.
 */
RTT_API bool composePropertyBag(const PropertyBag& source, PropertyBag& target);

}  // namespace types
}  // namespace RTT

#endif
