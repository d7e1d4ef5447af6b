// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "GlobalsRepository.hpp"

namespace RTT::types {

GlobalsRepository::shared_ptr GlobalsRepository::Instance() {
    // Never destroyed: plugins may refer to its contents.
    static auto* instance = new shared_ptr(new GlobalsRepository());
    return *instance;
}

}  // namespace RTT::types
