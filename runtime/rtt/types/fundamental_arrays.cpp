// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "GeneratedTypekit.hpp"

namespace RTT::types {

#define ORO_MAKE_HERE(E) template RTT_API TypeInfoGenerator* makeArrayType<E>(const char* name);
ORO_FUNDAMENTAL_TYPES(ORO_MAKE_HERE)
#undef ORO_MAKE_HERE

}  // namespace RTT::types
