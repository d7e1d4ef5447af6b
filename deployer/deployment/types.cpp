// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "types.hpp"

#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <string>
#include <vector>

namespace OCL::deploy {
namespace {

template <class Element>
void addSequence(const char* name) {
    const auto types = RTT::types::Types();
    if (!types->type(name)) types->addType(new RTT::types::SequenceTypeInfo<std::vector<Element>>(name));
}

}  // namespace

void addTypes() {
    addSequence<std::string>("strings");
    addSequence<int>("ints");
}

}  // namespace OCL::deploy
