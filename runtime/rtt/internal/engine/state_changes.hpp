// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_STATE_CHANGES_HPP
#define ORO_INTERNAL_STATE_CHANGES_HPP

#include <rtt/rtt-config.h>

#include <cstdint>

namespace RTT {
namespace internal {

/** Another number after a component of this process has changed its state or was destroyed: until then, none has. For
    those that look at many components often. Real-time safe, any thread. */
RTT_API std::uint64_t stateChanges();
/** By the component, after the change. Real-time safe. */
void countStateChange();

}  // namespace internal
}  // namespace RTT

#endif
