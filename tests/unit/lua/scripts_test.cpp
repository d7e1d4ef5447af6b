// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Every script in scripts/, executed by the service Lua of a deployer that has a component of C++ as peer.
#include "zoo.hpp"

#include <ocl/DeploymentComponent.hpp>
#include <rtt/Logger.hpp>
#include <rtt/os/startstop.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace {

std::vector<std::string> scripts() {
    std::vector<std::string> found;
    for (const auto& file : std::filesystem::directory_iterator(LUA_SCRIPTS)) {
        const std::string name = file.path().stem();
        if (file.path().extension() == ".lua" && name.compare(0, 5, "test_") == 0) found.push_back(name.substr(5));
    }
    std::sort(found.begin(), found.end());
    return found;
}

class LuaScripts : public testing::TestWithParam<std::string> {
protected:
    static void SetUpTestSuite() {
        static bool started = false;
        if (started) return;
        started = true;
        ::setenv("RTT_COMPONENT_PATH", OCL_TEST_PATH, 1);
        // Helpers of the scripts, and a small machine in place of rFSM.
        ::setenv("LUA_PATH", (std::string(LUA_SCRIPTS) + "/lib/?.lua;;").c_str(), 1);
        ASSERT_EQ(0, __os_init(0, nullptr));
    }
    LuaScripts() { RTT::Logger::Instance()->setStdStream(log_); }
    ~LuaScripts() override { RTT::Logger::Instance()->setStdStream(std::cerr); }

    std::ostringstream log_;
};

TEST_P(LuaScripts, Pass) {
    if (LUA_SANITIZED && GetParam() == "garbage") GTEST_SKIP() << "measures the memory of the process";
    OCL::DeploymentComponent deployer("Deployer");
    ASSERT_TRUE(deployer.import("ocl")) << log_.str();
    sample::addTypes();
    lua_test::Zoo zoo("zoo");
    ASSERT_TRUE(deployer.addPeer(&zoo));
    ASSERT_TRUE(zoo.configure());
    ASSERT_TRUE(deployer.loadService("Deployer", "Lua")) << log_.str();
    RTT::OperationCaller<bool(const std::string&)> run(deployer.provides("Lua")->getOperation("exec_file"));
    EXPECT_TRUE(run(std::string(LUA_SCRIPTS) + "/test_" + GetParam() + ".lua")) << log_.str();
    if (GetParam() == "module") {
        EXPECT_THAT(log_.str(), testing::HasSubstr("] a warning 4"));
        EXPECT_THAT(log_.str(), testing::HasSubstr("a line of 3 parts"));
    }
    deployer.kickOutAll();
}

INSTANTIATE_TEST_SUITE_P(Files, LuaScripts, testing::ValuesIn(scripts()), [](const auto& info) { return info.param; });

}  // namespace
