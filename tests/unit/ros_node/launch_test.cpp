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

}  // namespace
