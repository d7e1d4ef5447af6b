// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/rostopic.h>

namespace rtt_roscomm {

using RTT::ConnPolicy;

namespace {

ConnPolicy policyOf(const std::string& name, int type) {
    ConnPolicy policy(type, ConnPolicy::LOCK_FREE);
    policy.init = false;
    policy.pull = false;
    policy.size = 0;
    policy.transport = protocol_id;
    policy.name_id = name;
    return policy;
}

}  // namespace

ConnPolicy topic(const std::string& name) { return policyOf(name, ConnPolicy::DATA); }

ConnPolicy topicLatched(const std::string& name) {
    ConnPolicy policy = topic(name);
    policy.init = true;
    return policy;
}

ConnPolicy topicBuffer(const std::string& name, int size) {
    ConnPolicy policy = policyOf(name, ConnPolicy::BUFFER);
    policy.size = size;
    return policy;
}

ConnPolicy topicUnbuffered(const std::string& name) { return policyOf(name, ConnPolicy::UNBUFFERED); }

}  // namespace rtt_roscomm
