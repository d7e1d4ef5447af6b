// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Service `rosdeployment`, used by a client in this process.
#include "programs.hpp"

#include <rtt_ros_msgs/Eval.h>
#include <rtt_ros_msgs/GetPeerList.h>
#include <rtt_ros_msgs/RunScript.h>

#include <gmock/gmock.h>
#include <ros/ros.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

namespace {

using namespace ros_node_test;
using oroforge::test::ChildProcess;
using oroforge::test::Outcome;
using oroforge::test::RosMaster;
using oroforge::test::TempDir;
using testing::HasSubstr;

/** What rosservice prints, which reads the types in Python. */
std::string byTool(const std::string& service, const std::string& argument = "") {
    std::vector<std::string> words{"rosservice", "call", "/n/Deployer/" + service};
    if (!argument.empty()) words.push_back(argument);
    const Outcome called = RosMaster::tool(words);
    return called.out + called.err;
}

TEST(RosDeployment, ADeployerIsUsedByServices) {
    useToolchain();
    RosMaster master;
    TempDir folder;
    folder.write("x.ops",
                 "import(\"rtt_rosdeployment\")\nloadService(\"Deployer\", \"rosdeployment\")\n"
                 "loadService(\"Deployer\", \"print\")\nprint.ln(\"ready\")\n");
    folder.write("y.ops", "loadComponent(\"two\", \"OCL::HelloWorld\")\n");
    ChildProcess deployer(program("deployer", {"-s", "x.ops", "--", "__name:=n"}, folder));
    ASSERT_TRUE(deployer.waitForOutput("ready", std::chrono::seconds(10)));
    ros::init(ros::M_string(), "client", ros::init_options::NoSigintHandler);
    ros::NodeHandle node;
    rtt_ros_msgs::Eval code;
    code.request.code = "loadComponent(\"one\", \"OCL::HelloWorld\")";
    ASSERT_TRUE(ros::service::call("/n/Deployer/eval", code));
    EXPECT_TRUE(code.response.success);
    code.request.code = "loadComponent(";
    ASSERT_TRUE(ros::service::call("/n/Deployer/eval", code));
    EXPECT_FALSE(code.response.success);
    rtt_ros_msgs::RunScript script;
    script.request.file_path = folder.path().string() + "/y.ops";
    ASSERT_TRUE(ros::service::call("/n/Deployer/run_script", script));
    EXPECT_TRUE(script.response.success);
    script.request.file_path = "none.ops";
    ASSERT_TRUE(ros::service::call("/n/Deployer/run_script", script));
    EXPECT_FALSE(script.response.success);
    rtt_ros_msgs::GetPeerList list;
    ASSERT_TRUE(ros::service::call("/n/Deployer/get_peer_list", list));
    EXPECT_THAT(list.response.peers, testing::IsSupersetOf({"one", "two"}));
    EXPECT_THAT(byTool("eval", "print.ln(\"from a tool\")"), HasSubstr("success: True"));
    EXPECT_THAT(byTool("run_script", "none.ops"), HasSubstr("success: False"));
    EXPECT_THAT(byTool("get_peer_list"), HasSubstr("  - one\n  - two\n"));
    master.stop();
    ASSERT_TRUE(master.start());
    EXPECT_TRUE(becomes([] { return ros::service::exists("/n/Deployer/eval", false); })) << "known to a new master";
    EXPECT_TRUE(becomes([] { return ros::service::exists("/n/set_logger_level", false); }));
    ros::shutdown();
    master.send(SIGSTOP);
    const auto begin = std::chrono::steady_clock::now();
    deployer.send(SIGINT);
    const Outcome ended = deployer.finish();
    master.send(SIGCONT);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(6))
        << "a stopped master is not waited for";
    EXPECT_EQ(0, ended.status) << ended.out << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("from a tool"));
}

TEST(RosDeployment, NeedsANodeAndADeployer) {
    useToolchain();
    RosMaster master(RosMaster::Start::Later);
    TempDir folder;
    folder.write("x.ops",
                 "import(\"rtt_rosdeployment\")\nimport(\"ocl\")\nloadComponent(\"c\", \"OCL::HelloWorld\")\n"
                 "loadService(\"c\", \"rosdeployment\")\nloadService(\"Deployer\", \"rosdeployment\")\n");
    const Outcome ended = oroforge::test::run(program("rttscript", {"-s", "x.ops"}, folder));
    EXPECT_THAT(ended.out + ended.err, HasSubstr("'c' is no deployer"));
    EXPECT_THAT(ended.out + ended.err, HasSubstr("service rosdeployment: the ROS master at " + master.uri()));
}

}  // namespace
