// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// There is no replay: every thread sleeps until another one wakes it.
#ifndef OROFORGE_MODEL_OTHER_ORDER_HPP
#define OROFORGE_MODEL_OTHER_ORDER_HPP

#include <cstdint>

namespace RTT::internal {

struct OtherOrder {
    static bool executedHere() { return false; }
    static std::int64_t limit(std::int64_t deadline) { return deadline; }
};

}  // namespace RTT::internal

#endif
