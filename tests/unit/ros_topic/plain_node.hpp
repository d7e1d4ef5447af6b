// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_TOPIC_PLAIN_NODE_HPP
#define OROFORGE_TESTS_ROS_TOPIC_PLAIN_NODE_HPP

#include <support/ros_master.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

namespace ros {
class AsyncSpinner;
}

namespace ros_test {

/** Makes this process the node /tester of a master of its own, with the remapping old_name:=new_name. */
class PlainNode {
public:
    explicit PlainNode(std::uint32_t threads = 2);
    ~PlainNode();
    oroforge::test::RosMaster& master() { return master_; }

private:
    oroforge::test::RosMaster master_;
    std::unique_ptr<ros::AsyncSpinner> spinner_;
};

/** True as soon as `condition` is. */
bool soon(const std::function<bool()>& condition, std::chrono::milliseconds limit = std::chrono::seconds(10));

}  // namespace ros_test

#endif
