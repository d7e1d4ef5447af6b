// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "action_node.hpp"

#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt_roscomm/rtt_rostopic_ros_msg_transporter.hpp>

namespace action_test {

namespace {

template <class Message>
void addType() {
    const std::string name = std::string("/") + ros::message_traits::datatype<Message>();
    if (RTT::types::Types()->type(name)) return;
    RTT::types::Types()->addType(new RTT::types::TemplateTypeInfo<Message>(name));
    RTT::types::Types()->type(name)->addProtocol(ORO_ROS_PROTOCOL_ID, new rtt_roscomm::RosMsgTransporter<Message>());
}

}  // namespace

void addTypes() {
    RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE);
    RTT::plugin::PluginLoader::Instance()->loadLibrary(ACTIONLIB_SERVICE_FILE);
    addType<actionlib_msgs::GoalID>();
    addType<actionlib_msgs::GoalStatusArray>();
    addType<actionlib::TestActionGoal>();
    addType<actionlib::TestActionResult>();
    addType<actionlib::TestActionFeedback>();
}

Worker::Worker(const std::string& name) : TaskContext(name), server(provides(), 0.05) {
    server.setGoalHook([this](const actionlib::TestGoal& goal) { onGoal(goal); });
    server.setCancelHook([this] { onCancel(); });
}

void Worker::onGoal(const actionlib::TestGoal& goal) {
    server.acceptPending(result(8), "a newer goal");
    actionlib::TestFeedback feedback;
    feedback.feedback = 3;
    server.publishFeedback(feedback);
    if (goal.goal == 1) server.succeedActive(result(2), "well done");
}

}  // namespace action_test
