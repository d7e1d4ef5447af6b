// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "node.hpp"

#include <rtt/plugin/PluginLoader.hpp>
#include <rtt_roscomm/message_table.hpp>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>

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
    static const bool once = [] {
        RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE);
        addTransports();
        return true;
    }();
    (void)once;
}

}  // namespace ros_test
