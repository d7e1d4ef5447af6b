// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The place where older code looks for the view on arrays.
#ifndef ORO_INTERNAL_CARRAY_HPP
#define ORO_INTERNAL_CARRAY_HPP

#include <rtt/types/carray.hpp>

namespace RTT {
namespace internal {
using types::carray;
}
}  // namespace RTT

#endif
