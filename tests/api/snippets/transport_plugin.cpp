// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The includes of a package that transports types.
#include <rtt/TaskContext.hpp>
#include <rtt/types/TransportPlugin.hpp>
#include <rtt/types/TypekitPlugin.hpp>

#include <gtest/gtest.h>

namespace {

const int kProtocol = 1234;

struct NoTransporter : RTT::types::TypeTransporter {
    RTT::base::ChannelElementBase::shared_ptr createStream(RTT::base::PortInterface*, const RTT::ConnPolicy& policy,
                                                           bool is_sender) const {
        (void)policy.pull;
        (void)is_sender;
        return RTT::base::ChannelElementBase::shared_ptr();
    }
};

struct Plugin : RTT::types::TransportPlugin {
    bool registerTransport(std::string name, RTT::types::TypeInfo* info) {
        return name == info->getTypeName() && info->addProtocol(kProtocol, new NoTransporter());
    }
    std::string getTransportName() const { return "none"; }
    std::string getTypekitName() const { return "rtt-types"; }
    std::string getName() const { return "/user/none"; }
};

}  // namespace

TEST(UserCode, AddsATransportToAType) {
    RTT::types::TypeInfo type("/user/type");
    Plugin plugin;
    EXPECT_TRUE(plugin.registerTransport("/user/type", &type));
    EXPECT_TRUE(type.hasProtocol(kProtocol));
    RTT::types::TypeInfoRepository::shared_ptr types = RTT::types::TypeInfoRepository::Instance();
    EXPECT_EQ(types->type("/user/type"), nullptr) << "nobody added it";
}
