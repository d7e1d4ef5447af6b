// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_CONN_POLICY_HPP
#define ORO_CORBA_CONN_POLICY_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/transports/corba/DataFlowC.h>

/** Member by member; enumerators have the same numbers. */
RTT_API RTT::corba::CConnPolicy toCORBA(RTT::ConnPolicy const& policy);
RTT_API RTT::ConnPolicy toRTT(RTT::corba::CConnPolicy const& policy);

#endif
