// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The launch files with a real roslaunch.
#include "programs.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>

namespace {

using namespace ros_node_test;
using oroforge::test::ChildProcess;
using oroforge::test::Command;
using oroforge::test::Outcome;
using oroforge::test::RosMaster;
using oroforge::test::TempDir;
using testing::HasSubstr;

struct RosLaunch : testing::Test {
    RosLaunch() {
        useToolchain();
        setenv("OROCOS_TARGET", "", 1);  // counts as unset
    }
    Command roslaunch(std::vector<std::string> words) {
        Command command;
        command.program = "roslaunch";
        words.insert(words.begin(), "rtt_ros");
        command.arguments = words;
        command.directory = folder_.path();
        command.timeout = std::chrono::seconds(40);
        command.environment = {{"PYTHONUNBUFFERED", "1"}};
        return command;
    }
    /** Ends it as Ctrl-C does. */
    static Outcome interrupt(ChildProcess& launched) {
        const auto begin = std::chrono::steady_clock::now();
        launched.send(SIGINT);
        const Outcome ended = launched.finish();
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(4));
        return ended;
    }
    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    RosMaster master_;
    TempDir folder_;
};

const char kOps[] =
    "import(\"rtt_rosnode\")\nloadService(\"Deployer\", \"print\")\nprint.ln(\"node \" + ros.getNodeName())\n";

TEST_F(RosLaunch, DeployerRunsUntilItIsInterrupted) {
    folder_.write("app.ops", kOps);
    ChildProcess launched(roslaunch({"deployer.launch", "NAME:=arm", "DEPLOYER_ARGS:=-s " + file("app.ops")}));
    ASSERT_TRUE(launched.waitForOutput("node /arm", std::chrono::seconds(20)));
    EXPECT_THAT(RosMaster::tool({"rosnode", "list"}).out, HasSubstr("/arm\n"));
    const Outcome ended = interrupt(launched);
    EXPECT_EQ(0, ended.status) << ended.out << ended.err;
    EXPECT_TRUE(std::filesystem::exists(master_.folder() + "/orocos.log"));
    EXPECT_THAT(ended.out + ended.err, testing::Not(HasSubstr("escalating")));
}

TEST_F(RosLaunch, AFailingScriptEndsARequiredNodeWith255) {
    const Outcome ended = oroforge::test::run(
        roslaunch({"deployer.launch", "DEPLOYER_ARGS:=-s none.ops", "REQUIRED:=true", "LOG_LEVEL:=error"}));
    EXPECT_THAT(ended.out + ended.err, HasSubstr("exit code 255"));
    EXPECT_THAT(ended.out + ended.err, HasSubstr("REQUIRED process"));
    EXPECT_THAT(ended.out + ended.err,
                HasSubstr("none.ops: note: looked for in the working folder, " + master_.folder()));
}

TEST_F(RosLaunch, CheckAndDryRunAreOptions) {
    folder_.write("app.xml",
                  "<?xml version=\"1.0\"?>\n<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n<properties>\n"
                  "<simple name=\"Import\" type=\"string\"><value>ocl</value></simple>\n</properties>\n");
    const Outcome shown =
        oroforge::test::run(roslaunch({"--args", "/arm", "deployer.launch", "NAME:=arm", "CHECK:=true", "DRY_RUN:=true",
                                       "CORBA:=true", "LAUNCH_PREFIX:=nice -n 5"}));
    EXPECT_EQ(0, shown.status) << shown.err;
    EXPECT_THAT(shown.out, HasSubstr("nice -n 5 " + kPrefix + "/lib/rtt_ros/deployer-corba -l info --check --dry-run"));
    EXPECT_THAT(shown.out, HasSubstr(" -- __name:=arm"));
    const Outcome checked = oroforge::test::run(
        roslaunch({"deployer.launch", "DEPLOYER_ARGS:=-s " + file("app.xml"), "CHECK:=true", "REQUIRED:=true"}));
    EXPECT_THAT(checked.out + checked.err, HasSubstr("finished cleanly")) << checked.out << checked.err;
}

TEST_F(RosLaunch, DebugRunsGdb) {
    const Outcome shown =
        oroforge::test::run(roslaunch({"--args", "/arm", "deployer.launch", "NAME:=arm", "DEBUG:=true"}));
    EXPECT_THAT(shown.out, HasSubstr("/lib/rtt_ros/deployer-debug -l info"));
    const Outcome lua = oroforge::test::run(roslaunch({"--args", "/arm", "rttlua.launch", "NAME:=arm", "SCREEN:=true",
                                                       "DEBUG:=true", "INTERACTIVE:=false", "RTTLUA_ARGS:=a.lua"}));
    EXPECT_THAT(lua.out, HasSubstr("/lib/rtt_ros/rttlua-screen a.lua - __name:=arm"));
}

TEST_F(RosLaunch, LuaScriptsDeployInLdeployerAndRttlua) {
    folder_.write("app.lua",
                  "local tc = rtt.getTC()\nlocal d = tc:getName() == 'Deployer' and tc or tc:getPeer('Deployer')\n"
                  "d:import('rtt_ros')\nd:import('rtt_ros')\nd:import('rtt_rosnode')\n"
                  "print(tc:getName() .. ' is ' .. rtt.provides('ros'):getNodeName())\n");
    {
        ChildProcess launched(roslaunch(
            {"ldeployer.launch", "NAME:=arm", "LOG_LEVEL:=warning", "DEPLOYER_ARGS:=-g -s " + file("app.lua")}));
        ASSERT_TRUE(launched.waitForOutput("Deployer is /arm", std::chrono::seconds(20)));
        const Outcome ended = interrupt(launched);
        EXPECT_EQ(0, ended.status);
        EXPECT_THAT(ended.err + ended.out, HasSubstr("ldeployer: option -g has no meaning here, and is left out"));
    }
    {
        ChildProcess launched(roslaunch({"ldeployer.launch", "NAME:=leg", "LUA_SCRIPTS:=" + file("app.lua")}));
        ASSERT_TRUE(launched.waitForOutput("Deployer is /leg", std::chrono::seconds(20)));
        interrupt(launched);
    }
    ChildProcess launched(roslaunch({"rttlua.launch", "NAME:=hand", "RTTLUA_ARGS:=" + file("app.lua")}));
    ASSERT_TRUE(launched.waitForOutput("lua is /hand", std::chrono::seconds(20)));
    EXPECT_THAT(RosMaster::tool({"rosnode", "list"}).out, HasSubstr("/hand\n"));  // goes on after its script
    EXPECT_EQ(0, interrupt(launched).status);
}

TEST_F(RosLaunch, NodesAreRespawned) {
    ChildProcess launched(roslaunch({"deployer.launch", "RESPAWN:=true", "DEPLOYER_ARGS:=-s none.ops"}));
    EXPECT_TRUE(launched.waitForOutput("restarting process", std::chrono::seconds(20)));
    interrupt(launched);
}

/** The launch file of the slides: a deployer with Lua or OPS, and a node in Python beside it. */
const char kSlides[] = R"xml(<launch>
  <arg name="LUA" default="true"/>
  <include if="$(arg LUA)" file="$(find rtt_ros)/launch/ldeployer.launch">
    <arg name="DEPLOYER_ARGS" value="-g -s $(find slides)/example.lua"/>
    <arg name="LOG_LEVEL" value="info"/>
    <arg name="DEBUG" value="false"/>
  </include>
  <include unless="$(arg LUA)" file="$(find rtt_ros)/launch/deployer.launch">
    <arg name="DEPLOYER_ARGS" value="-s $(find slides)/example.ops"/>
    <arg name="LOG_LEVEL" value="info"/>
    <arg name="DEBUG" value="false"/>
  </include>
  <node name="server" pkg="slides" type="server.py" launch-prefix="/usr/bin/python3" output="screen"/>
</launch>
)xml";

TEST_F(RosLaunch, TheSlidesHaveADeployerAndANodeInPython) {
    folder_.write("slides/package.xml",
                  "<package format=\"2\"><name>slides</name><version>1.0.0</version><description>d</description>"
                  "<maintainer email=\"a@b.cc\">A</maintainer><license>none</license></package>");
    folder_.write("slides/launch/slides.launch", kSlides);
    folder_.write("slides/example.lua",
                  "local d = rtt.getTC()\nd:import('ocl')\nd:import('rtt_ros')\nlocal ros = rtt.provides('ros')\n"
                  "ros:import('rtt_rosnode')\nros:import('rtt_std_msgs')\nd:loadComponent('hello', 'OCL::HelloWorld')\n"
                  "d:stream('hello.the_results', ros:topic('/chatter'))\nlocal c = d:getPeer('hello')\n"
                  "c:configure()\nc:start()\n");
    folder_.write("slides/example.ops",
                  "import(\"ocl\")\nimport(\"rtt_ros\")\nros.import(\"rtt_rosnode\")\nros.import(\"rtt_std_msgs\")\n"
                  "loadComponent(\"hello\", \"OCL::HelloWorld\")\nstream(\"hello.the_results\", "
                  "ros.topic(\"/chatter\"))\nhello.configure()\nhello.start()\n");
    std::filesystem::copy(SERVER_SCRIPT, folder_ / "slides/server.py");
    std::filesystem::permissions(folder_ / "slides/server.py", std::filesystem::perms::owner_all);
    setenv("ROS_PACKAGE_PATH", (folder_.path().string() + ":" + kPrefix + "/share").c_str(), 1);
    for (const char* lua : {"LUA:=true", "LUA:=false"}) {
        SCOPED_TRACE(lua);
        Command command = roslaunch({"slides.launch", lua});
        command.arguments[0] = "slides";
        ChildProcess launched(command);
        ASSERT_TRUE(launched.waitForOutput("ready", std::chrono::seconds(20)));  // the node in Python
        EXPECT_THAT(RosMaster::tool({"rosservice", "call", "/switch", "true"}).out, HasSubstr("message: \"on\""));
        EXPECT_EQ("data: \"Hello World!\"\n---\n", RosMaster::tool({"rostopic", "echo", "-n", "1", "/chatter"}).out);
        const Outcome ended = interrupt(launched);
        EXPECT_EQ(0, ended.status) << ended.out << ended.err;
    }
    EXPECT_TRUE(std::filesystem::exists(master_.folder() + "/orocos.log"));
}

}  // namespace
