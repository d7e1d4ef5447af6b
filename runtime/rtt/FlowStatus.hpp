// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The results of writing to and reading from a port.
#ifndef ORO_FLOW_STATUS_HPP
#define ORO_FLOW_STATUS_HPP

#include <rtt/rtt-config.h>

#include <iosfwd>

namespace RTT {

/** Result of InputPort::read(). NoData is 0, so `if (port.read(x))` means "is there any value". */
enum FlowStatus { NoData = 0, OldData = 1, NewData = 2 };

/** Result of OutputPort::write(); larger is worse. */
enum WriteStatus { WriteSuccess = 0, WriteFailure = 1, NotConnected = 2 };

/** Prints the enumerator's name. Not real-time safe. */
RTT_API std::ostream& operator<<(std::ostream& os, FlowStatus status);
RTT_API std::ostream& operator<<(std::ostream& os, WriteStatus status);

/** Reads an enumerator's name; any other word gives NoData, or WriteSuccess. Not real-time safe. */
RTT_API std::istream& operator>>(std::istream& is, FlowStatus& status);
RTT_API std::istream& operator>>(std::istream& is, WriteStatus& status);

}  // namespace RTT

#endif
