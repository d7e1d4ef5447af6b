// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One header must do for a transporter.
#include <rtt/types/TypeTransporter.hpp>

#include <gtest/gtest.h>

namespace {

struct Transporter : RTT::types::TypeTransporter {
    RTT::base::ChannelElementBase::shared_ptr createStream(RTT::base::PortInterface* port,
                                                           const RTT::ConnPolicy& policy, bool) const {
        EXPECT_EQ(port, nullptr);
        return policy.pull ? new RTT::base::ChannelElementBase() : 0;
    }
};

}  // namespace

TEST(UserCode, MakesAStream) {
    RTT::ConnPolicy policy;
    EXPECT_FALSE(Transporter().createStream(0, policy, true));
    policy.pull = true;
    EXPECT_TRUE(Transporter().createStream(0, policy, true));
}
