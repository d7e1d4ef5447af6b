// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_RECONFIGURE_RECONFIGURE_FIXTURE_HPP
#define OROFORGE_TESTS_ROS_RECONFIGURE_RECONFIGURE_FIXTURE_HPP

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>
#include <rtt/TaskContext.hpp>
#include <rtt_dynamic_reconfigure/auto_config.h>
#include <support/ros_master.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace ros {
class AsyncSpinner;
}

namespace reconfigure_test {

using dynamic_reconfigure::Config;
using dynamic_reconfigure::ConfigDescription;
using oroforge::test::RosMaster;
using rtt_dynamic_reconfigure::AutoConfig;
using rtt_dynamic_reconfigure::Server;
using rtt_dynamic_reconfigure::ServerBase;

/** Loads the plugins. */
void load();

/** Makes this process the node /tester of a master of its own. */
class Node {
public:
    Node();
    ~Node();
    RosMaster& master() { return master_; }

private:
    RosMaster master_;
    std::unique_ptr<ros::AsyncSpinner> spinner_;
};

bool soon(const std::function<bool()>& condition, std::chrono::milliseconds limit = std::chrono::seconds(10));

/** A request with one value. */
Config a(const std::string& name, bool value);
Config a(const std::string& name, int value);
Config a(const std::string& name, double value);
Config a(const std::string& name, const char* value);
Config operator+(Config one, const Config& other);

/** Calls `<ns>/set_parameters`; false if that is refused. */
bool set(const std::string& ns, const Config& request, Config* response = nullptr);
/** The last message of a latched topic. */
Config updateOf(const std::string& ns);
ConfigDescription descriptionOf(const std::string& ns);

/** The value of a parameter as text; "-" if there is none. */
std::string in(const Config& config, const std::string& name);

/** The service of a component, loaded as scripts do. */
ServerBase& serverOf(RTT::TaskContext& component);

}  // namespace reconfigure_test

#endif
