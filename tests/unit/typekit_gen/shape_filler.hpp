// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Values of any type with a shape, so that readers have something to find.
#ifndef OROFORGE_TESTS_SHAPE_FILLER_HPP
#define OROFORGE_TESTS_SHAPE_FILLER_HPP

#include <rtt/types/TypeInfo.hpp>

namespace oroforge::test {

/// Sets all numbers and texts in a value to different ones; containers get two elements, down to some depth.
void fillShape(const RTT::types::TypeInfo& type, void* value, unsigned seed);

}  // namespace oroforge::test

#endif
