// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that executes statements with the types of messages.
#ifndef OROFORGE_TESTS_ROS_MESSAGES_MESSAGE_SCRIPT_HPP
#define OROFORGE_TESTS_ROS_MESSAGES_MESSAGE_SCRIPT_HPP

#include <rtt/RTT.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <unit/flow/log_capture.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace ros_messages_test {

class ScriptTest : public testing::Test {
protected:
    explicit ScriptTest(const std::string& package) {
        const auto loader = RTT::plugin::PluginLoader::Instance();
        EXPECT_TRUE(loader->loadLibrary(RTT_TYPEKIT_FILE));
        loader->setPluginPath(PACKAGES);
        EXPECT_TRUE(loader->loadTypekit(package));
        service.reset(new RTT::scripting::ScriptingService(&host));
        host.provides()->addService(service);
        host.addAttribute("text", text);
        host.addAttribute("number", number);
        host.addAttribute("count", count);
    }
    static RTT::types::TypeInfo* type(const std::string& name) { return RTT::types::Types()->type(name); }
    bool eval(const std::string& code) { return service->eval(code); }

    flow_test::LogCapture log;
    RTT::TaskContext host{"host"};
    RTT::scripting::ScriptingService::shared_ptr service;
    std::string text;
    double number = 0;
    int count = 0;
};

}  // namespace ros_messages_test

#endif
