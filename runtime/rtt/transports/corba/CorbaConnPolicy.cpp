// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/CorbaConnPolicy.hpp>

using RTT::ConnPolicy;
using RTT::corba::CConnPolicy;

CConnPolicy toCORBA(ConnPolicy const& policy) {
    CConnPolicy made;
    made.type = static_cast<RTT::corba::CConnectionModel>(policy.type < 0 ? 0 : policy.type);
    made.size = policy.size;
    made.lock_policy = static_cast<RTT::corba::CLockPolicy>(policy.lock_policy);
    made.init = policy.init;
    made.pull = policy.pull;
    made.buffer_policy = static_cast<RTT::corba::CBufferPolicy>(policy.buffer_policy);
    made.max_threads = policy.max_threads;
    made.mandatory = policy.mandatory;
    made.transport = policy.transport;
    made.data_size = policy.data_size;
    made.name_id = policy.name_id.c_str();
    return made;
}

ConnPolicy toRTT(CConnPolicy const& policy) {
    ConnPolicy made;
    made.type = policy.type;
    made.size = policy.size;
    made.lock_policy = policy.lock_policy;
    made.init = policy.init;
    made.pull = policy.pull;
    made.buffer_policy = policy.buffer_policy;
    made.max_threads = policy.max_threads;
    made.mandatory = policy.mandatory;
    made.transport = policy.transport;
    made.data_size = policy.data_size;
    made.name_id = policy.name_id.in();
    return made;
}
