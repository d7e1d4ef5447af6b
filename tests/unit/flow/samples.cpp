// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "samples.hpp"

#include <cstdlib>

namespace flow_test {

std::uint64_t stressCount(std::uint64_t normally) {
    const char* factor = std::getenv("OROFORGE_STRESS");
    const std::uint64_t times = factor ? std::strtoull(factor, nullptr, 10) : 1;
    return normally * (times ? times : 1);
}

}  // namespace flow_test
