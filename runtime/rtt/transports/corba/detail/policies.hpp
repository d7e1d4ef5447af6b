// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What both ends of a connection make of a policy.
#ifndef ORO_CORBA_DETAIL_POLICIES_HPP
#define ORO_CORBA_DETAIL_POLICIES_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/transports/corba/CorbaLib.hpp>

namespace RTT {
namespace corba {
namespace detail {

/** With what the policy leaves open, or what two threads cannot have. */
inline ConnPolicy completed(ConnPolicy policy) {
    if (policy.buffer_policy == UnspecifiedBufferPolicy) policy.buffer_policy = PerConnection;
    if (policy.lock_policy == ConnPolicy::UNSYNC) policy.lock_policy = ConnPolicy::LOCKED;  // a thread at each end
    if (policy.buffer_policy == PerInputPort) policy.pull = ConnPolicy::PUSH;
    if (policy.buffer_policy == PerOutputPort) policy.pull = ConnPolicy::PULL;
    return policy;
}

/** For the storage at one end, which is of this connection, whatever the other process has. */
inline ConnPolicy ofOneConnection(ConnPolicy policy) {
    policy.buffer_policy = PerConnection;
    return policy;
}

/** The samples cross by another transport. */
inline bool isOutOfBand(const ConnPolicy& policy) {
    return policy.transport != 0 && policy.transport != ORO_CORBA_PROTOCOL_ID;
}

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
