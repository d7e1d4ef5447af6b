// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_THIS_THREAD_HPP
#define ORO_INTERNAL_DETAIL_THIS_THREAD_HPP

#include <rtt/internal/Reclaimer.hpp>

namespace RTT {
namespace internal {
namespace detail {

/** Never null, different for all threads that live. A new thread may have that of one that ended; all that the old one did
    happens before the new one gets it. Real-time safe, see Reclaimer::Guard. */
inline const void* thisThread() noexcept { return Reclaimer::thisThread(); }

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
