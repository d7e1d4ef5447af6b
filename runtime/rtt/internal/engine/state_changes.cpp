// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/state_changes.hpp>

#include <atomic>

namespace RTT::internal {
namespace {
std::atomic<std::uint64_t> changes{0};
}

std::uint64_t stateChanges() { return changes.load(std::memory_order_acquire); }
void countStateChange() { changes.fetch_add(1, std::memory_order_acq_rel); }

}  // namespace RTT::internal
