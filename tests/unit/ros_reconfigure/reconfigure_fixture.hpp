// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_RECONFIGURE_RECONFIGURE_FIXTURE_HPP
#define OROFORGE_TESTS_ROS_RECONFIGURE_RECONFIGURE_FIXTURE_HPP

#include "../ros_topic/plain_node.hpp"

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>
#include <rtt/TaskContext.hpp>
#include <rtt_dynamic_reconfigure/auto_config.h>

#include <string>

namespace reconfigure_test {

using dynamic_reconfigure::Config;
using dynamic_reconfigure::ConfigDescription;
using oroforge::test::RosMaster;
using ros_test::soon;
using rtt_dynamic_reconfigure::AutoConfig;
using rtt_dynamic_reconfigure::Server;
using rtt_dynamic_reconfigure::ServerBase;

/** Loads the plugins. */
void load();

/** A node whose process has loaded them. */
class Node : public ros_test::PlainNode {
public:
    Node() : PlainNode(4) { load(); }
};

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
