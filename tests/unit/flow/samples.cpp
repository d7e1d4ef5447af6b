// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "samples.hpp"

#include <cstdlib>

#ifndef OROFORGE_STRESS_DEFAULT
#define OROFORGE_STRESS_DEFAULT 1
#endif

namespace flow_test {

std::uint64_t stressCount(std::uint64_t normally) {
    const char* factor = std::getenv("OROFORGE_STRESS");
    const std::uint64_t times = factor ? std::strtoull(factor, nullptr, 10) : OROFORGE_STRESS_DEFAULT;
    return normally * (times ? times : 1);
}

}  // namespace flow_test
