// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_TOPOLOGY_HPP
#define ORO_INTERNAL_TOPOLOGY_HPP

#include <rtt/rtt-config.h>

#include <cstdint>

namespace RTT {
namespace internal {

/** Counts the changes of peers and activities of all components, for code that keeps a list of components up to date.
    It wraps around. */
struct RTT_API Topology {
    /** Read it before the components. Real-time safe. */
    static std::uint32_t changes() noexcept;
    /** Call it after the change. */
    static void changed() noexcept;
};

}  // namespace internal
}  // namespace RTT

#endif
