// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The built-in types. Their templates are instantiated where they are used: no library besides the runtime is needed.
#ifndef ORO_TYPEKIT_TYPES_HPP
#define ORO_TYPEKIT_TYPES_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/FlowStatus.hpp>
#include <rtt/PropertyBag.hpp>
#include <string>
#include <vector>

#endif
