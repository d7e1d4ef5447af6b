// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"

#include <rtt/typekit/BoolTypeInfo.hpp>
#include <rtt/typekit/StdTypeInfo.hpp>
#include <rtt/types/TypeInfoName.hpp>

namespace RTT::types::builtin {

void addFundamentalTypes() {
    const auto types = Types();
    types->addType(new StdTypeInfo<int>("int"));
    types->addType(new StdTypeInfo<unsigned int>("uint"));
    types->addType(new StdTypeInfo<double>("double"));
    types->addType(new StdTypeInfo<float>("float"));
    types->addType(new StdTypeInfo<char>("char"));
    types->addType(new BoolTypeInfo());
    types->addType(new StdTypeInfo<long long>("llong"));
    types->addType(new StdTypeInfo<unsigned long long>("ullong"));
    types->addType(new TypeInfoName<void>("void"));  // operations without a result name it
}

}  // namespace RTT::types::builtin
