// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The life cycle of a component whose hooks are Lua functions.
#include "lua_fixture.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>

#include <support/temp_dir.hpp>

namespace {

using namespace lua_test;
using RTT::TaskContext;

class LuaLife : public LuaTest {};

TEST_F(LuaLife, StartsPreOperationalAndDoesNothingWithoutHooks) {
    EXPECT_EQ(TaskContext::PreOperational, component.getTaskState());
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    component.update();
    EXPECT_TRUE(component.isRunning());
    EXPECT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
}

TEST_F(LuaLife, CallsEachHook) {
    ASSERT_TRUE(
        run("calls = ''\n"
            "function configureHook() calls = calls .. 'c' return true end\n"
            "function startHook() calls = calls .. 's' return true end\n"
            "function updateHook() calls = calls .. 'u' end\n"
            "function stopHook() calls = calls .. 'S' end\n"
            "function cleanupHook() calls = calls .. 'C' end\n"
            "function activateHook() calls = calls .. 'a' return true end\n"));
    EXPECT_TRUE(component.activate());
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    component.update();
    component.update();
    component.stop();
    component.cleanup();
    EXPECT_EQ("acsuuSC", value("calls"));
}

TEST_F(LuaLife, HooksSayWhetherTheySucceed) {
    ASSERT_TRUE(run("function configureHook() return ok end function startHook() return started end"));
    ASSERT_TRUE(run("ok = false"));
    EXPECT_FALSE(component.configure());
    ASSERT_TRUE(run("ok = true started = false"));
    EXPECT_TRUE(component.configure());
    EXPECT_FALSE(component.start());
    ASSERT_TRUE(run("started = true"));
    EXPECT_TRUE(component.start());
}

TEST_F(LuaLife, AHookThatReturnsNoBoolFailsAndIsReported) {
    ASSERT_TRUE(run("function configureHook() return 1 end"));
    const std::string log = logged([this] { EXPECT_FALSE(component.configure()); });
    EXPECT_THAT(log, testing::HasSubstr("configureHook has to return a bool, and returned a number"));
}

TEST_F(LuaLife, ConfigureExecutesTheStringThenTheFile) {
    oroforge::test::TempDir folder;
    const std::string file = folder.path() / "f.lua";
    std::ofstream(file) << "order = order .. 'file' function configureHook() order = order .. ' hook' return true end";
    set<std::string>("lua_string", "order = 'string '");
    set<std::string>("lua_file", file);
    ASSERT_TRUE(component.configure());
    EXPECT_EQ("string file hook", value("order"));
}

TEST_F(LuaLife, ConfigureFailsWithAFileThatCannotBeExecuted) {
    set<std::string>("lua_file", "/does/not/exist.lua");
    const std::string log = logged([this] { EXPECT_FALSE(component.configure()); });
    EXPECT_THAT(log, testing::HasSubstr("/does/not/exist.lua"));
    set<std::string>("lua_file", "");
    set<std::string>("lua_string", "x = = 1");
    EXPECT_FALSE(component.configure());
}

TEST_F(LuaLife, AnErrorInUpdateHookIsAnException) {
    ASSERT_TRUE(
        run("function updateHook() local nothing = nil; return nothing.x end\n"
            "function exceptionHook() seen = true end"));
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    const std::string log = logged([this] { component.update(); });
    EXPECT_EQ(TaskContext::Exception, component.getTaskState());
    EXPECT_THAT(log, testing::HasSubstr("attempt to index local 'nothing'"));
    EXPECT_THAT(log, testing::HasSubstr("'lua_component'"));
    EXPECT_EQ("true", value("seen"));
    EXPECT_TRUE(component.recover());
}

TEST_F(LuaLife, ErrorHookReplacesUpdateHookAfterError) {
    ASSERT_TRUE(run("n = 0 function updateHook() rtt.getTC():error() end function errorHook() n = n + 1 end"));
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    component.update();
    component.update();
    EXPECT_EQ(TaskContext::RunTimeError, component.getTaskState());
    EXPECT_EQ("true", value("n >= 1"));
}

TEST_F(LuaLife, SamplesOfAnEventPortTriggerUpdateHook) {
    OCL::LuaComponent echo("echo");
    ASSERT_TRUE(
        echo.exec_str("local tc = rtt.getTC()\n"
                      "inport = rtt.InputPort.new('double', 'in') tc:addEventPort(inport)\n"
                      "outport = rtt.OutputPort.new('double', 'out') tc:addPort(outport)\n"
                      "function updateHook()\n"
                      "  local status, x = inport:read()\n"
                      "  if status == 'NewData' then outport:write(2 * x) end\n"
                      "end"));
    RTT::OutputPort<double> to("to");
    RTT::InputPort<double> from("from");
    ASSERT_TRUE(to.connectTo(echo.getPort("in"), RTT::ConnPolicy::buffer(10)));
    ASSERT_TRUE(from.connectTo(echo.getPort("out"), RTT::ConnPolicy::buffer(10)));
    ASSERT_TRUE(echo.configure());
    ASSERT_TRUE(echo.start());
    to.write(21);
    double sample = 0;
    for (int i = 0; i != 2000 && from.read(sample) != RTT::NewData; ++i) usleep(1000);
    EXPECT_EQ(42, sample);
}

TEST_F(LuaLife, OperationsOfLuaAreOperationsForCpp) {
    ASSERT_TRUE(
        run("rtt.getTC():addOperation('scale', 'double(double x, int n)', function(x, n) return x * n end)\n"
            "rtt.getTC():addOperation('name', 'string(const string& s)', function(s) return s .. '!' end)\n"
            "rtt.getTC():addOperation('fail', 'void()', function() error('on purpose') end)"));
    RTT::OperationCaller<double(double, int)> scale(component.getOperation("scale"));
    ASSERT_TRUE(scale.ready());
    EXPECT_EQ(7.5, scale(2.5, 3));
    RTT::OperationCaller<std::string(const std::string&)> name(component.getOperation("name"));
    ASSERT_TRUE(name.ready());
    EXPECT_EQ("ab!", name("ab"));
    RTT::OperationCaller<void()> fail(component.getOperation("fail"));
    ASSERT_TRUE(fail.ready());
    try {
        fail();
        FAIL() << "no exception";
    } catch (const std::exception& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("on purpose"));
    }
}

TEST_F(LuaLife, WhatLuaMadeLeavesWithTheComponent) {
    RTT::InputPort<double> reader("reader");
    {
        OCL::LuaComponent gone("gone");
        ASSERT_TRUE(
            gone.exec_str("p = rtt.OutputPort.new('double', 'p') rtt.getTC():addPort(p) "
                          "q = rtt.Property.new('double', 'q') rtt.getTC():addProperty(q)"));
        ASSERT_TRUE(reader.connectTo(gone.getPort("p"), RTT::ConnPolicy::data()));
        ASSERT_TRUE(reader.connected());
    }
    EXPECT_FALSE(reader.connected());
}

}  // namespace
