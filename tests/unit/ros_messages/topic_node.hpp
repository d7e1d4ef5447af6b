// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// This process as a node that has imported packages, and what roscpp's own subscriber receives.
#ifndef OROFORGE_TESTS_ROS_MESSAGES_TOPIC_NODE_HPP
#define OROFORGE_TESTS_ROS_MESSAGES_TOPIC_NODE_HPP

#include <ros/init.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <rtt/RTT.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <support/ros_master.hpp>
#include <unit/flow/log_capture.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace ros_messages_test {

class TopicNode : public testing::Test {
protected:
    TopicNode() {
        ros::init(ros::M_string(), "tester", ros::init_options::NoSigintHandler);
        ros::start();
        spinner_.emplace(2);
        spinner_->start();
        EXPECT_TRUE(loader->loadLibrary(RTT_TYPEKIT_FILE));
        loader->setPluginPath(PACKAGES);
    }
    ~TopicNode() override {
        spinner_->stop();
        ros::shutdown();
    }
    /** Types and plugins of a package. */
    void import(const std::string& package) { EXPECT_TRUE(loader->loadTypekit(package)); }
    static RTT::ConnPolicy topic(const std::string& name) {
        RTT::ConnPolicy policy = RTT::ConnPolicy::data();
        policy.transport = 3;
        policy.name_id = name;
        return policy;
    }
    static bool soon(const std::function<bool()>& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return true;
    }

    flow_test::LogCapture log;
    oroforge::test::RosMaster master;
    RTT::plugin::PluginLoader::shared_ptr loader = RTT::plugin::PluginLoader::Instance();

private:
    std::optional<ros::AsyncSpinner> spinner_;
};

template <class Message>
class Listener {
public:
    explicit Listener(const std::string& topic)
        : subscriber_(node_.subscribe<Message>(topic, 10, [this](const typename Message::ConstPtr& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              last_ = *message;
          })) {}
    std::optional<Message> last() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return last_;
    }
    bool isConnected() const { return subscriber_.getNumPublishers() != 0; }

private:
    ros::NodeHandle node_;
    std::mutex mutex_;
    std::optional<Message> last_;
    ros::Subscriber subscriber_;
};

}  // namespace ros_messages_test

#endif
