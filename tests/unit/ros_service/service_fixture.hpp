// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A node with spinners, its master, and a component that has the service rosservice.
#ifndef TESTS_UNIT_ROS_SERVICE_FIXTURE_HPP
#define TESTS_UNIT_ROS_SERVICE_FIXTURE_HPP

#include <rtt/TaskContext.hpp>
#include <rtt_roscomm/rosservice.h>
#include <std_srvs/Empty.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <gtest/gtest.h>
#include <support/child_process.hpp>
#include <support/ros_master.hpp>

#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

namespace service_test {

using oroforge::test::ChildProcess;
using oroforge::test::Outcome;
using oroforge::test::RosMaster;
using RTT::ClientThread;
using RTT::OperationCaller;
using RTT::OwnThread;

/** One for the process. The first use makes this process a node, with these names in place of others. */
RosMaster& master(const std::map<std::string, std::string>& remapped = {});
/** Loads plugins and makes std_srvs known, as rtt_std_srvs does. */
void loadServices();

/** What is logged meanwhile. */
class LogText {
public:
    LogText();
    ~LogText();
    std::string text() const { return text_.str(); }
    bool has(const std::string& part) const { return text().find(part) != std::string::npos; }

private:
    std::ostringstream text_;
};

/** Operations of all signatures for std_srvs. */
class Pump : public RTT::TaskContext {
public:
    explicit Pump(const std::string& name);
    ~Pump() override { stopForGood(); }
    boost::shared_ptr<rtt_roscomm::ROSService> services;
    bool isOn = false;
    std::thread::id thread;  // that executed an operation last

    OperationCaller<bool(std_srvs::SetBool::Request&, std_srvs::SetBool::Response&)> standard{"standard"};
    OperationCaller<bool(bool, std::string&)> withMessage{"withMessage"};
    OperationCaller<bool(bool)> plain{"plain"};
    OperationCaller<std::string(bool)> asText{"asText"};
    OperationCaller<void(bool)> quiet{"quiet"};
    OperationCaller<bool(std::string&)> trigger{"trigger"};
    OperationCaller<bool()> ping{"ping"};
    OperationCaller<void()> poke{"poke"};
    OperationCaller<double(int)> odd{"odd"};
};

class ServiceTest : public ::testing::Test {
protected:
    ServiceTest();
    ~ServiceTest() override;
    /** The services that the master knows, by the tool of ROS. */
    static std::string listed();
    /** A Python node with the services of server.py. */
    static std::unique_ptr<ChildProcess> startServer(const std::string& seconds = "30");

    std::unique_ptr<Pump> pump;
};

}  // namespace service_test

#endif
