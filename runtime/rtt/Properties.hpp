// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTIES_HPP
#define ORO_PROPERTIES_HPP

#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>

#endif
