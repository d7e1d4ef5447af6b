// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "plain_node.hpp"

#include <ros/init.h>
#include <ros/spinner.h>

#include <thread>

namespace ros_test {

PlainNode::PlainNode(std::uint32_t threads) : process_(process(threads)) {}

PlainNode::Process& PlainNode::process(std::uint32_t threads) {
    static Process made(threads);
    return made;
}

PlainNode::Process::Process(std::uint32_t threads) {
    ros::M_string remappings;
    remappings["old_name"] = "new_name";
    ros::init(remappings, "tester", ros::init_options::NoSigintHandler);
    ros::start();
    spinner = std::make_unique<ros::AsyncSpinner>(threads);
    spinner->start();
}

PlainNode::Process::~Process() {
    spinner->stop();
    ros::shutdown();
}

std::unique_ptr<oroforge::test::ChildProcess> publish(const std::string& topic, const std::string& type,
                                                      const std::string& value) {
    oroforge::test::Command command;
    command.program = "rostopic";
    command.arguments = {"pub", topic, type, value};
    return std::make_unique<oroforge::test::ChildProcess>(command);
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
