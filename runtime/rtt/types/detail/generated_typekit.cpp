// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/types/GeneratedTypekit.hpp>

#include <rtt/types/TypeInfoRepository.hpp>

namespace RTT::types {

bool addType(TypeInfoGenerator* generator) { return Types()->addType(generator); }

bool aliasType(const char* alias, const char* of) { return Types()->aliasType(alias, Types()->type(of)); }

}  // namespace RTT::types
