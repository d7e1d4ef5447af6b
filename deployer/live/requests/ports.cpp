// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ports.hpp"

#include <rtt/types/Types.hpp>

namespace OCL::live {

using RTT::base::PortInterface;

std::string typeOfPort(const PortInterface& port) {
    return RTT::types::Types()->toDot(port.getTypeInfo()->getTypeName());
}

}  // namespace OCL::live
