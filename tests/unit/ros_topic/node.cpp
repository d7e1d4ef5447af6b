// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "node.hpp"

#include <ros/init.h>
#include <ros/spinner.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt_roscomm/message_table.hpp>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>

#include <thread>

namespace ros_test {

namespace {

template <class Message>
rtt_roscomm::MessageEntry entry(const char* type) {
    namespace traits = ros::message_traits;
    return {type, traits::datatype<Message>(), traits::md5sum<Message>(), traits::definition<Message>()};
}

void addTransports() {
    static const rtt_roscomm::MessageEntry table[] = {entry<std_msgs::Bool>("bool"), entry<std_msgs::Float64>("double"),
                                                      entry<std_msgs::Int32>("int"), entry<std_msgs::String>("string"),
                                                      entry<std_msgs::Float64MultiArray>("array")};
    RTT::types::TypekitRepository::Import(new rtt_roscomm::MessageTransport("test", table, std::size(table)));
}

}  // namespace

Node::Node() {
    ros::M_string remappings;
    remappings["old_name"] = "new_name";
    ros::init(remappings, "tester", ros::init_options::NoSigintHandler);
    ros::start();
    spinner_ = std::make_unique<ros::AsyncSpinner>(2);
    spinner_->start();
    RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE);
    addTransports();
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

}  // namespace ros_test
