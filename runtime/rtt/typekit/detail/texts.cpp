// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"

#include <rtt/rt_string.hpp>
#include <rtt/typekit/StdStringTypeInfo.hpp>
#include <rtt/types/StdVectorTypeInfo.hpp>

namespace RTT {
namespace types {
namespace builtin {

void addTexts() {
    Types()->addType(new StdStringTypeInfo());
    Types()->addType(new StdBasicStringTypeInfo<rt_string>("rt_string"));
    Types()->addType(new StdVectorTypeInfo<double>());
}

}  // namespace builtin
}  // namespace types
}  // namespace RTT
