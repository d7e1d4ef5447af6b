// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/internal/SendHandleC.hpp>
#include <rtt/types/PrimitiveTypeInfo.hpp>

namespace RTT::types::builtin {

void addComponentTypes() {
    Types()->addType(new PrimitiveTypeInfo<TaskContext*>("TaskContext"));
    Types()->addType(new PrimitiveTypeInfo<internal::SendHandleC>("SendHandle"));
}

}  // namespace RTT::types::builtin
