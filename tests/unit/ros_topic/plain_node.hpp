// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_TOPIC_PLAIN_NODE_HPP
#define OROFORGE_TESTS_ROS_TOPIC_PLAIN_NODE_HPP

#include <support/ros_master.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace ros {
class AsyncSpinner;
}

namespace ros_test {

/** Makes this process the node /tester of a master of its own, with the remapping old_name:=new_name. It stays one until it
    ends: later objects are the same node. */
class PlainNode {
public:
    explicit PlainNode(std::uint32_t threads = 2);
    oroforge::test::RosMaster& master() { return process_.master; }

private:
    struct Process {
        explicit Process(std::uint32_t threads);
        ~Process();
        oroforge::test::RosMaster master;
        std::unique_ptr<ros::AsyncSpinner> spinner;
    };
    static Process& process(std::uint32_t threads);
    Process& process_;
};

/** `rostopic pub` of one message, from now until the object's end: a tool that ends by itself stays for seconds. */
std::unique_ptr<oroforge::test::ChildProcess> publish(const std::string& topic, const std::string& type,
                                                      const std::string& value);

/** True as soon as `condition` is. */
bool soon(const std::function<bool()>& condition, std::chrono::milliseconds limit = std::chrono::seconds(10));

}  // namespace ros_test

#endif
