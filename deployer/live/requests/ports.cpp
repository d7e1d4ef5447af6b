// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ports.hpp"

#include <rtt/types/Types.hpp>

namespace OCL::live {

using RTT::base::PortInterface;

std::string policyText(const RTT::ConnPolicy& policy) {
    switch (policy.type) {
        case RTT::ConnPolicy::DATA: return "data";
        case RTT::ConnPolicy::BUFFER: return "buffer " + std::to_string(policy.size);
        case RTT::ConnPolicy::CIRCULAR_BUFFER: return "circular buffer " + std::to_string(policy.size);
        default: return "unbuffered";
    }
}

std::string typeOfPort(const PortInterface& port) {
    return RTT::types::Types()->toDot(port.getTypeInfo()->getTypeName());
}

}  // namespace OCL::live
