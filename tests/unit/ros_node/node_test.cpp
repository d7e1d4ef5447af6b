// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// rtt_rosnode: the process becomes a node when the master is there, and ends in order.
#include "programs.hpp"

#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/startstop.h>
#include <rtt_ros/node.hpp>

#include <gmock/gmock.h>

#include <csignal>

namespace {

using namespace ros_node_test;
using oroforge::test::ChildProcess;
using oroforge::test::Outcome;
using oroforge::test::RosMaster;
using oroforge::test::TempDir;
using testing::HasSubstr;

TEST(RosNode, IsThereAtARepeatedImportWhenTheMasterIs) {
    useToolchain();
    RosMaster master(RosMaster::Start::Later);
    std::vector<std::string> words = {"test", "__name:=later"};
    std::vector<char*> argv = {words[0].data(), words[1].data(), nullptr};
    ASSERT_EQ(0, __os_init(2, argv.data()));
    const auto loader = RTT::ComponentLoader::Instance();
    const auto begin = std::chrono::steady_clock::now();
    std::string why;
    EXPECT_FALSE(rtt_ros::isNodeReady(why));
    EXPECT_EQ("this process is no ROS node: import rtt_rosnode first", why);
    EXPECT_TRUE(loader->import("rtt_rosnode", ""));
    EXPECT_FALSE(rtt_ros::isNodeReady(why));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
    EXPECT_THAT(why, HasSubstr("the ROS master at " + master.uri() + " does not answer: Connection refused; start it"));
    ASSERT_TRUE(master.start());
    EXPECT_TRUE(loader->import("rtt_rosnode", ""));
    EXPECT_TRUE(rtt_ros::isNodeReady(why)) << why;
    EXPECT_EQ("later", words[1].substr(8));  // the arguments are as they were
    EXPECT_THAT(RosMaster::tool({"rosnode", "list"}).out, HasSubstr("/later\n"));
    __os_exit();
    EXPECT_FALSE(rtt_ros::isNodeReady(why));
    EXPECT_EQ("the ROS node of this process has been shut down", why);
}

struct RosNodeProgram : testing::Test {
    RosNodeProgram() { useToolchain(); }
    TempDir folder_;
};

TEST_F(RosNodeProgram, TakesTheArgumentsOfRos) {
    RosMaster master;
    folder_.write("x.ops",
                  "import(\"rtt_rosnode\")\nloadService(\"Deployer\", \"print\")\nprint.ln(ros.getNodeName() + \" \" + "
                  "ros.getNamespace())\n");
    ChildProcess deployer(program("deployer", {"-s", "x.ops", "--", "__name:=n", "__ns:=robot", "_p:=3"}, folder_));
    ASSERT_TRUE(deployer.waitForOutput("/robot/n /robot", std::chrono::seconds(10)));
    EXPECT_THAT(RosMaster::tool({"rosnode", "list"}).out, HasSubstr("/robot/n\n"));
    EXPECT_EQ("3\n", RosMaster::tool({"rosparam", "get", "/robot/n/p"}).out);
    deployer.send(SIGTERM);
    const Outcome ended = deployer.finish();
    EXPECT_EQ(0, ended.status) << ended.err;
    EXPECT_THAT(RosMaster::tool({"rosnode", "list"}).out, testing::Not(HasSubstr("/robot/n\n")));
}

TEST_F(RosNodeProgram, InvalidNamesAndUrisAreErrors) {
    RosMaster master;
    folder_.write("x.ops", "import(\"rtt_rosnode\")\n");
    const Outcome name = oroforge::test::run(program("rttscript", {"-s", "x.ops", "--", "__name:=a/b"}, folder_));
    EXPECT_EQ(255, name.status);
    EXPECT_THAT(name.out + name.err, HasSubstr("this process cannot be a ROS node: Invalid node name [a/b]"));
    const Outcome uri = oroforge::test::run(program("rttscript", {"-s", "x.ops", "--", "__master:=home"}, folder_));
    EXPECT_EQ(255, uri.status);
    EXPECT_THAT(uri.out + uri.err, HasSubstr("'home' is no URI of a ROS master"));
}

TEST_F(RosNodeProgram, EndsWithStatusZeroBySignals) {
    RosMaster master;
    folder_.write("x.ops", "import(\"rtt_rosnode\")\nloadService(\"Deployer\", \"print\")\nprint.ln(\"ready\")\n");
    const char* const wanted = std::getenv("ORO_ROS_RUNS");  // ./dev stress has 100
    for (int run = 0; run < (wanted ? std::atoi(wanted) : 6); ++run) {
        ChildProcess deployer(program("deployer", {"-s", "x.ops", "--", "__name:=n"}, folder_));
        ASSERT_TRUE(deployer.waitForOutput("ready", std::chrono::seconds(10)));
        deployer.send(run % 2 == 0 ? SIGINT : SIGTERM);
        const Outcome ended = deployer.finish();
        ASSERT_EQ(0, ended.status) << ended.out << ended.err;
    }
}

/** Two components wait for each other's services for ever, publish, and are subscribed. */
const char kWaiting[] = R"(import("rtt_ros")
ros.import("rtt_rosnode")
ros.import("rtt_std_msgs")
ros.import("rtt_std_srvs")
import("WAITING")
loadComponent("a", "Waiting")
loadComponent("b", "Waiting")
loadService("a", "rosservice")
loadService("b", "rosservice")
stream("a.out", ros.topicBuffer("/a", 10))
stream("b.out", ros.topicLatched("/b"))
stream("a.in", ros.topicBuffer("/b", 10))
stream("b.in", ros.topicBuffer("/a", 10))
a.rosservice.connect("answer", "/a/answer", "std_srvs/Trigger")
b.rosservice.connect("answer", "/b/answer", "std_srvs/Trigger")
a.rosservice.connect("here", "/a/here", "std_srvs/Trigger")
a.rosservice.connect("ask", "/b/answer", "std_srvs/Trigger")
b.rosservice.connect("ask", "/a/answer", "std_srvs/Trigger")
setActivity("a", 0.01, 0, ORO_SCHED_OTHER)
setActivity("b", 0.01, 0, ORO_SCHED_OTHER)
a.start()
b.start()
)";

TEST_F(RosNodeProgram, TellsThatAnotherNodeTookItsName) {
    const RosMaster master;
    folder_.write("x.ops",
                  "import(\"rtt_ros\")\nros.import(\"rtt_rosnode\")\nros.import(\"rtt_std_msgs\")\n"
                  "loadComponent(\"hello\", \"OCL::HelloWorld\")\nloadService(\"Deployer\", \"print\")\n"
                  "stream(\"hello.the_results\", ros.topic(\"/chatter\"))\nprint.ln(\"ready\")\n");
    ChildProcess first(program("deployer", {"-s", "x.ops", "--", "__name:=n"}, folder_));
    ASSERT_TRUE(first.waitForOutput("ready", std::chrono::seconds(10)));
    ChildProcess second(program("deployer", {"-s", "x.ops", "--", "__name:=n"}, folder_));
    ASSERT_TRUE(second.waitForOutput("ready", std::chrono::seconds(10)));
    std::this_thread::sleep_for(std::chrono::seconds(2));
    EXPECT_THAT(RosMaster::tool({"rostopic", "list"}).out, HasSubstr("/chatter"));
    first.send(SIGINT);
    second.send(SIGINT);
    const Outcome told = first.finish(), ended = second.finish();
    EXPECT_EQ(0, told.status) << told.out << told.err;
    EXPECT_THAT(told.out + told.err,
                HasSubstr("the ROS node /n has been shut down, because another node took its name"));
    EXPECT_EQ(0, ended.status) << ended.out << ended.err;
    EXPECT_THAT(ended.out + ended.err, testing::Not(HasSubstr("shut down")));
}

TEST_F(RosNodeProgram, EndsInTimeWithCallsThatWait) {
    RosMaster master;
    std::string script = kWaiting;
    script.replace(script.find("WAITING"), 7, WAITING_COMPONENT);
    folder_.write("x.ops", script);
    const char* const wanted = std::getenv("ORO_ROS_RUNS");  // ./dev stress has 100
    for (int run = 0; run < (wanted ? std::atoi(wanted) : 3); ++run) {
        SCOPED_TRACE(run);
        const bool isStopped = run % 3 == 1, isGone = run % 3 == 2;  // the master, before the program
        ChildProcess deployer(program("deployer", {"-s", "x.ops", "--", "__name:=n"}, folder_));
        for (const char* name : {"a waits", "b waits"})
            ASSERT_TRUE(deployer.waitForOutput(name, std::chrono::seconds(10)));
        if (isStopped) master.send(SIGSTOP);
        if (isGone) master.stop();
        const auto begin = std::chrono::steady_clock::now();
        deployer.send(run % 2 == 0 ? SIGINT : SIGTERM);
        const Outcome ended = deployer.finish();
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        if (isStopped) master.send(SIGCONT);
        ASSERT_TRUE(!isGone || master.start());
        ASSERT_EQ(0, ended.status) << ended.out << ended.err;
        EXPECT_LT(taken.count(), 6) << ended.out << ended.err;
        std::cout << "run " << run << " ended in " << taken.count() << " s" << std::endl;
        if (isStopped) continue;
        EXPECT_EQ("\n", RosMaster::tool({"rosnode", "list"}).out);
    }
}

}  // namespace
