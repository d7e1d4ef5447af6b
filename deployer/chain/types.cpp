// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "types.hpp"

#include <ocl/ChainStatistics.hpp>

#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <string>
#include <vector>

namespace OCL::chain {
namespace {

template <class Info>
void add(const char* name) {
    const auto types = RTT::types::Types();
    if (!types->type(name)) types->addType(new Info(name));
}

}  // namespace

void addTypes() {
    using RTT::types::SequenceTypeInfo;
    using RTT::types::StructTypeInfo;
    add<SequenceTypeInfo<std::vector<std::string>>>("strings");
    add<StructTypeInfo<ChainTimes>>("ChainTimes");
    add<StructTypeInfo<ChainMember>>("ChainMember");
    add<SequenceTypeInfo<std::vector<ChainMember>>>("ChainMember[]");
    add<StructTypeInfo<ChainStatistics>>("ChainStatistics");
}

}  // namespace OCL::chain
