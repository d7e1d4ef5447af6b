// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <kdl_conversions/kdl_msg.h>
#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

TEST(RosKdl, MessagesBecomeObjectsAndBack) {
    ASSERT_TRUE(RTT::plugin::PluginLoader::Instance()->loadLibrary(CONVERSIONS));
    const RTT::Service::shared_ptr kdl = RTT::internal::GlobalService::Instance()->getService("KDL");
    ASSERT_TRUE(kdl);
    for (const char* name : {"point", "pose", "quaternion", "transform", "twist", "vector", "wrench"}) {
        EXPECT_TRUE(kdl->hasOperation(name + std::string("MsgToKDL"))) << name;
        EXPECT_TRUE(kdl->hasOperation(name + std::string("KDLToMsg"))) << name;
    }
    RTT::OperationCaller<KDL::Frame(const geometry_msgs::Pose&)> toKdl = kdl->getOperation("poseMsgToKDL");
    RTT::OperationCaller<geometry_msgs::Pose(const KDL::Frame&)> toMessage = kdl->getOperation("poseKDLToMsg");
    ASSERT_TRUE(toKdl.ready());
    ASSERT_TRUE(toMessage.ready());
    geometry_msgs::Pose pose;
    pose.position.x = 1;
    pose.orientation.z = 1;  // half a turn about z
    const KDL::Frame frame = toKdl(pose);
    EXPECT_NEAR(1, frame.p.x(), 1e-12);
    EXPECT_NEAR(-1, frame.M.UnitX().x(), 1e-12);
    EXPECT_NEAR(1, toMessage(frame).orientation.z, 1e-12);
}

}  // namespace
