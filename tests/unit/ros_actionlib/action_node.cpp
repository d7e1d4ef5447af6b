// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "action_node.hpp"

#include <ros/init.h>
#include <ros/spinner.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt_roscomm/rtt_rostopic_ros_msg_transporter.hpp>

#include <thread>

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

Node::Node() {
    ros::init(ros::M_string(), "tester", ros::init_options::NoSigintHandler);
    ros::start();
    spinner_ = std::make_unique<ros::AsyncSpinner>(2);
    spinner_->start();
    addTypes();
}

Node::~Node() {
    spinner_->stop();
    ros::shutdown();
}

bool soon(const std::function<bool()>& condition, std::chrono::milliseconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
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
