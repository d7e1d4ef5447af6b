// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is not allowed.
#include "requests_fixture.hpp"

#include <live/requests/failure.hpp>

#include <set>

namespace live_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST_F(RequestsTest, WhatIsNotAllowedNamesTheOption) {
    rights = {};
    EXPECT_EQ("LIV005: 'oro.set' is not allowed here; the deployer's option --web-allow=properties allows it",
              failure("set", {{"path", "Arm.gain"}, {"value", 1}}));
    EXPECT_THAT(failure("call", {{"path", "Arm.add"}}), HasSubstr("--web-allow=operations"));
    EXPECT_THAT(failure("lifecycle", {{"component", "Arm"}, {"do", "start"}}), HasSubstr("--web-allow=lifecycle"));
    for (const char* const verb : {"stop", "line", "complete", "interrupt"})
        EXPECT_EQ(std::string("LIV005: 'oro.") + verb +
                      "' is not allowed here; only 'oro' on the same computer, without --url, may do it",
                  failure(verb, {{"line", "1"}}));
    EXPECT_FALSE(stopped);
    EXPECT_EQ(2.5, result("get", {{"path", "Arm.gain"}})["value"]);
}

TEST_F(RequestsTest, OperationsAreNoWayAroundOtherPermissions) {
    rights = {};
    rights.operations = true;
    for (const char* const path : {"Arm.start", "Arm.this.start", "Arm.setPeriod", "Arm.loadService", "Deployer.add",
                                   "this.start", "isRunning", "Arm.Deployer.isRunning"}) {
        arm->addPeer(deployer.get());
        EXPECT_THAT(failure("call", {{"path", path}}),
                    testing::AllOf(StartsWith("LIV005: operation '"), HasSubstr("--web-allow=lifecycle")))
            << path;
    }
    EXPECT_FALSE(arm->isRunning());
    EXPECT_EQ(false, result("call", {{"path", "Arm.isRunning"}})["value"]);
    EXPECT_EQ(3, result("call", {{"path", "Arm.add"}, {"arguments", {1, 2}}})["value"]);
    rights.lifecycle = true;
    EXPECT_EQ(true, result("call", {{"path", "Arm.start"}})["value"]);
    ASSERT_TRUE(arm->loadService("scripting"));
    EXPECT_THAT(failure("call", {{"path", "Arm.scripting.eval"}, {"arguments", {"Arm.stop()"}}}),
                StartsWith("LIV005: operation 'Arm.scripting.eval' executes code"));
    EXPECT_TRUE(arm->isRunning());
}

TEST_F(RequestsTest, OperationsSayWhetherTheClientMayCallThem) {
    const auto allowed = [this](const std::string& path) {
        std::set<std::string> names;
        const auto shown = result("show", {{"path", path}});
        for (const auto& operation : shown.at("operations"))
            if (operation.at("allowed") == true) names.insert(operation.at("name").get<std::string>());
        return names;
    };
    deployer->addOperation("runScript", std::function<bool()>([] { return true; }));
    rights = {};
    EXPECT_THAT(allowed("Arm"), testing::IsEmpty());
    rights.operations = true;
    EXPECT_THAT(allowed("Arm"), testing::AllOf(Contains("add"), Contains("isRunning"), Not(Contains("start"))));
    EXPECT_THAT(allowed(""), testing::IsEmpty());
    EXPECT_EQ(false, result("show", {{"path", "Arm.start"}})["allowed"]);
    rights.lifecycle = true;
    EXPECT_THAT(allowed("Arm"), Contains("start"));
    EXPECT_THAT(allowed(""), testing::AllOf(Contains("start"), Not(Contains("runScript"))));
    rights.console = true;
    EXPECT_THAT(allowed(""), Contains("runScript"));
}

TEST_F(RequestsTest, OnlyAConsoleReachesFilesAndPrograms) {
    bool executed = false;
    const std::function<bool(const std::string&)> execute = [&executed](const std::string&) { return executed = true; };
    for (const char* const name : {"os", "Lua", "LuaTLSF"}) {
        const auto service = RTT::Service::Create(name);
        service->addOperation("execute", execute);
        ASSERT_TRUE(arm->provides()->addService(service));
    }
    arm->addOperation("exec_str", execute);
    for (const char* const name : {"runScript", "kickStart", "loadComponents", "loadConfigurationString", "import"})
        deployer->addOperation(name, execute);
    std::string code;
    arm->addProperty("lua_string", code);
    rights = {};
    rights.properties = rights.operations = rights.lifecycle = true;
    for (const char* const path :
         {"Arm.os.execute", "Arm.Lua.execute", "Arm.LuaTLSF.execute", "Arm.exec_str", "runScript", "Deployer.kickStart",
          "Arm.Deployer.loadComponents", "loadConfigurationString", "import"}) {
        arm->addPeer(deployer.get());
        EXPECT_THAT(failure("call", {{"path", path}, {"arguments", {"touch x"}}}),
                    testing::AllOf(StartsWith("LIV005: operation '"), HasSubstr("executes code or commands")))
            << path;
    }
    EXPECT_FALSE(executed);
    EXPECT_THAT(failure("set", {{"path", "Arm.lua_string"}, {"value", "os.execute('x')"}}),
                StartsWith("LIV005: 'Arm.lua_string' is code"));
    EXPECT_EQ("", code);
    std::string path = "/opt", own = "/opt";
    deployer->addProperty("RTT_COMPONENT_PATH", path);
    arm->addProperty("RTT_COMPONENT_PATH", own);
    for (const char* const name : {"RTT_COMPONENT_PATH", "this.RTT_COMPONENT_PATH", "Arm.Deployer.RTT_COMPONENT_PATH"})
        EXPECT_THAT(failure("set", {{"path", name}, {"value", "/tmp"}}), StartsWith("LIV005: '")) << name;
    EXPECT_EQ("/opt", path);
    EXPECT_EQ("/tmp", result("set", {{"path", "Arm.RTT_COMPONENT_PATH"}, {"value", "/tmp"}})["value"]);
    rights.console = true;
    EXPECT_EQ(true, result("call", {{"path", "Arm.os.execute"}, {"arguments", {"touch x"}}})["value"]);
    EXPECT_EQ("return 1", result("set", {{"path", "Arm.lua_string"}, {"value", "return 1"}})["value"]);
}

}  // namespace
}  // namespace live_test
