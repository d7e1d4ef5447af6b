// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SEND_STATUS_HPP
#define ORO_SEND_STATUS_HPP

#include <rtt/rtt-config.h>

#include <iosfwd>

namespace RTT {

/** The status of a sent operation. Positive means success, zero means not yet. */
enum SendStatus {
    CollectFailure = -2,  ///< it cannot be collected, because no caller was set
    SendFailure = -1,     ///< it was never queued
    SendNotReady = 0,     ///< it is still waiting or executing
    SendSuccess = 1       ///< it is done
};

/** Writes the name of the enumerator. */
RTT_API std::ostream& operator<<(std::ostream& os, SendStatus status);
/** Reads a name; anything unknown gives SendFailure. */
RTT_API std::istream& operator>>(std::istream& is, SendStatus& status);

}  // namespace RTT

#endif
