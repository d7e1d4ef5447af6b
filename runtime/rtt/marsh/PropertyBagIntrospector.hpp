// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where older code looks for this visitor.
#ifndef ORO_MARSH_PROPERTY_BAG_INTROSPECTOR_HPP
#define ORO_MARSH_PROPERTY_BAG_INTROSPECTOR_HPP

#include <rtt/types/PropertyBagIntrospector.hpp>

namespace RTT {
namespace marsh {
using types::PropertyBagIntrospector;
}
}  // namespace RTT

#endif
