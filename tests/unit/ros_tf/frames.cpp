// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "frames.hpp"

#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt/types/Types.hpp>
#include <rtt_roscomm/rtt_rostopic_ros_msg_transporter.hpp>
#include <tf2_msgs/TFMessage.h>

#include <cmath>

namespace ros_test {

geometry_msgs::TransformStamped moved(const std::string& frame, const std::string& child, double x,
                                      const ros::Time& time) {
    geometry_msgs::TransformStamped made;
    made.header.stamp = time;
    made.header.frame_id = frame;
    made.child_frame_id = child;
    made.transform.translation.x = x;
    made.transform.rotation.w = 1;
    return made;
}

void addMessageTypes() {
    const auto types = RTT::types::Types();
    types->addType(new RTT::types::TemplateTypeInfo<tf2_msgs::TFMessage>("/tf2_msgs/TFMessage"));
    types->type("/tf2_msgs/TFMessage")->addProtocol(3, new rtt_roscomm::RosMsgTransporter<tf2_msgs::TFMessage>());
    typedef geometry_msgs::TransformStamped Stamped;
    types->addType(new RTT::types::TemplateTypeInfo<Stamped>("/geometry_msgs/TransformStamped"));
    types->type("/geometry_msgs/TransformStamped")->addProtocol(3, new rtt_roscomm::RosMsgTransporter<Stamped>());
}

Frames::Frames() {
    const auto loader = RTT::ComponentLoader::Instance();
    if (loader->loadLibrary(RTT_TF_FILE)) tf = loader->loadComponent("tf", "rtt_tf::RTT_TF");
    if (!tf) throw std::runtime_error("rtt_tf::RTT_TF cannot be loaded");
    user.connectServices(tf);
}

Frames::~Frames() {
    user.requires_("tf")->disconnect();
    if (tf) RTT::ComponentLoader::Instance()->unloadComponent(tf);
}

double Frames::x(const std::string& target, const std::string& source) {
    const auto found = calls.lookupTransform(target, source);
    return found.header.frame_id.empty() ? NAN : found.transform.translation.x;
}

bool Frames::isAt(double expected, const std::string& target, const std::string& source) {
    return soon([&] { return std::abs(x(target, source) - expected) < 1e-9; });
}

}  // namespace ros_test
