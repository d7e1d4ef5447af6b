// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_THIS_THREAD_HPP
#define ORO_INTERNAL_DETAIL_THIS_THREAD_HPP

#include <rtt/internal/flow/reclaimer.hpp>

namespace RTT {
namespace internal {
namespace detail {

/** An identity of this thread, never null and unique among existing threads. A new thread may get that of one that
    ended; everything the old one did happens before that. Real-time safe, see Reclaimer::Guard. */
inline const void* thisThread() noexcept { return Reclaimer::thisThread(); }

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
