// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "plain_node.hpp"

#include <ros/init.h>
#include <ros/spinner.h>

#include <thread>

namespace ros_test {

PlainNode::PlainNode(std::uint32_t threads) {
    ros::M_string remappings;
    remappings["old_name"] = "new_name";
    ros::init(remappings, "tester", ros::init_options::NoSigintHandler);
    ros::start();
    spinner_ = std::make_unique<ros::AsyncSpinner>(threads);
    spinner_->start();
}

PlainNode::~PlainNode() {
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
