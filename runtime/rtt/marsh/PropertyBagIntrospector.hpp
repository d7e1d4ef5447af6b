// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Older code includes the visitor from here.
#ifndef ORO_MARSH_PROPERTY_BAG_INTROSPECTOR_HPP
#define ORO_MARSH_PROPERTY_BAG_INTROSPECTOR_HPP

#include <rtt/types/PropertyBagIntrospector.hpp>

namespace RTT {
namespace marsh {
using types::PropertyBagIntrospector;
}
}  // namespace RTT

#endif
