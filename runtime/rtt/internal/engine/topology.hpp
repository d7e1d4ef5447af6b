// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_TOPOLOGY_HPP
#define ORO_INTERNAL_TOPOLOGY_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {

/** Counts the changes of peers and activities of all components, for code that keeps a list of components up to date.
    It wraps around. */
class RTT_API Topology {
public:
    /** Read it before the components. Real-time safe. */
    static std::uint32_t changes() noexcept { return changes_.load(std::memory_order_acquire); }
    /** Call it after the change. */
    static void changed() noexcept { changes_.fetch_add(1, std::memory_order_acq_rel); }

private:
    static std::atomic<std::uint32_t> changes_;
};

}  // namespace internal
}  // namespace RTT

#endif
