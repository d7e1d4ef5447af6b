// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/ConnPolicy.hpp>

#include <istream>
#include <ostream>

namespace RTT {

// Needed where their address is taken, for example by std::min or a reference parameter.
const int ConnPolicy::UNBUFFERED;
const int ConnPolicy::DATA;
const int ConnPolicy::BUFFER;
const int ConnPolicy::CIRCULAR_BUFFER;
const int ConnPolicy::UNSYNC;
const int ConnPolicy::LOCKED;
const int ConnPolicy::LOCK_FREE;
const bool ConnPolicy::PUSH;
const bool ConnPolicy::PULL;

namespace {

struct Name {
    int value;
    const char* text;
};
const Name kBufferPolicies[] = {{UnspecifiedBufferPolicy, "(unspecified buffer policy)"},
                                {PerConnection, "PerConnection"},
                                {PerInputPort, "PerInputPort"},
                                {PerOutputPort, "PerOutputPort"},
                                {Shared, "Shared"}};
const Name kLockPolicies[] = {
    {ConnPolicy::UNSYNC, "UNSYNC"}, {ConnPolicy::LOCKED, "LOCKED"}, {ConnPolicy::LOCK_FREE, "LOCK_FREE"}};
const Name kTypes[] = {{ConnPolicy::UNBUFFERED, "UNBUFFERED"},
                       {ConnPolicy::DATA, "DATA"},
                       {ConnPolicy::BUFFER, "BUFFER"},
                       {ConnPolicy::CIRCULAR_BUFFER, "CIRCULAR_BUFFER"}};

template <std::size_t N>
const char* nameOf(const Name (&names)[N], int value, const char* unknown) {
    for (const Name& name : names)
        if (name.value == value) return name.text;
    return unknown;
}

}  // namespace

std::ostream& operator<<(std::ostream& os, BufferPolicy policy) {
    return os << nameOf(kBufferPolicies, policy, "(unknown buffer policy)");
}

std::istream& operator>>(std::istream& is, BufferPolicy& policy) {
    std::string word;
    is >> word;
    policy = UnspecifiedBufferPolicy;
    for (const Name& name : kBufferPolicies)
        if (word == name.text) policy = static_cast<BufferPolicy>(name.value);
    return is;
}

ConnPolicy& ConnPolicy::Default() {
    static ConnPolicy policy{Builtin{}};
    return policy;
}

ConnPolicy::ConnPolicy(Builtin)
    : type(DATA),
      size(0),
      lock_policy(LOCK_FREE),
      init(false),
      pull(PUSH),
      buffer_policy(PerConnection),
      max_threads(0),
      mandatory(true),
      transport(0),
      data_size(0) {}

ConnPolicy::ConnPolicy() : ConnPolicy(Default()) { name_id.clear(); }

const ConnPolicy& internal::policyOfPorts() {
    thread_local ConnPolicy policy;
    policy = ConnPolicy();
    return policy;
}

ConnPolicy::ConnPolicy(int type_) : ConnPolicy() { type = type_; }

ConnPolicy::ConnPolicy(int type_, int lock_policy_) : ConnPolicy(type_) { lock_policy = lock_policy_; }

ConnPolicy ConnPolicy::buffer(int size, int lock_policy, bool init_connection, bool pull) {
    ConnPolicy policy(BUFFER, lock_policy);
    policy.size = size;
    policy.init = init_connection;
    policy.pull = pull;
    return policy;
}

ConnPolicy ConnPolicy::circularBuffer(int size, int lock_policy, bool init_connection, bool pull) {
    ConnPolicy policy = buffer(size, lock_policy, init_connection, pull);
    policy.type = CIRCULAR_BUFFER;
    return policy;
}

ConnPolicy ConnPolicy::data(int lock_policy, bool init_connection, bool pull) {
    ConnPolicy policy(DATA, lock_policy);
    policy.init = init_connection;
    policy.pull = pull;
    return policy;
}

std::ostream& operator<<(std::ostream& os, const ConnPolicy& policy) {
    os << (policy.pull ? "PULL " : "PUSH ") << static_cast<BufferPolicy>(policy.buffer_policy) << ' '
       << nameOf(kLockPolicies, policy.lock_policy, "(unknown lock policy)") << ' '
       << nameOf(kTypes, policy.type, "(unknown connection type)");
    if (policy.size > 0) os << '[' << policy.size << ']';
    if (!policy.name_id.empty()) os << " (name_id=" << policy.name_id << ')';
    if (policy.max_threads > 0) os << " (max_threads=" << policy.max_threads << ')';
    return os;
}

}  // namespace RTT
