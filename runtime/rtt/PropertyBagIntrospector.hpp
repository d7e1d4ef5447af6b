// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The place where older code looks for this visitor.
#ifndef ORO_OLD_PROPERTY_BAG_INTROSPECTOR_HPP
#define ORO_OLD_PROPERTY_BAG_INTROSPECTOR_HPP

#include <rtt/types/PropertyBagIntrospector.hpp>

namespace RTT {
using types::PropertyBagIntrospector;
}

#endif
