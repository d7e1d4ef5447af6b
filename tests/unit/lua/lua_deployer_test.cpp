// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Lua files in the deployer: by command line, by scripts, by XML, and only checked.
#include "../deployer/deployer_program.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace {

using oroforge::test::Outcome;
using testing::HasSubstr;

class LuaDeployer : public deployer_test::DeployerInDirectory {
protected:
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(directory_.path() / name) << text;
    }
    Outcome deploy(const std::vector<std::string>& words) const { return oroforge::test::run(command(words)); }
    Outcome script(const std::vector<std::string>& words) const {
        oroforge::test::Command made = command(words);
        made.program = RTTSCRIPT_PROGRAM;
        return oroforge::test::run(made);
    }
};

const char kScript[] =
    "local d = rtt.getTC()\n"
    "assert(d:getName() == 'Deployer')\n"
    "assert(d:import('ocl'))\n"
    "assert(d:loadComponent('h', 'OCL::HelloWorld'))\n"
    "local h = d:getPeer('h')\n"
    "assert(h:configure() and h:start())\n"
    "print('state of h: ' .. h:getState())\n";

TEST_F(LuaDeployer, RunsAScript) {
    write("a.lua", kScript);
    const Outcome by = script({"a.lua"});
    EXPECT_EQ(0, by.status) << by.out + by.err;
    EXPECT_THAT(by.out + by.err, HasSubstr("state of h: Running"));
    const Outcome option = script({"-s", "a.lua"});
    EXPECT_EQ(0, option.status) << option.out + option.err;
}

TEST_F(LuaDeployer, OpsScriptsRunLuaScripts) {
    write("a.lua", kScript);
    write("a.ops", "if !runScript(\"a.lua\") then return\nh.stop()\n");
    const Outcome by = script({"a.ops"});
    EXPECT_EQ(0, by.status) << by.out + by.err;
    EXPECT_THAT(by.out + by.err, HasSubstr("state of h: Running"));
}

TEST_F(LuaDeployer, AFailingScriptIsLocatedAndEndsTheProgram) {
    write("bad.lua", "local x = 1\nrtt.getTC():getPeer('nobody')\n");
    const Outcome by = script({"bad.lua"});
    EXPECT_EQ(255, by.status);
    EXPECT_THAT(by.out + by.err, HasSubstr("bad.lua:2: "));
    EXPECT_THAT(by.out + by.err, HasSubstr("'nobody'"));
}

TEST_F(LuaDeployer, PeriodAndPriorityInTheWrongOrderGetAHint) {
    write("slides.lua",
          "local d = rtt.getTC() d:import('ocl') d:loadComponent('h', 'OCL::HelloWorld')\n"
          "print(d:setActivity('h', 98, 0.01, rtt.globals.ORO_SCHED_RT))");
    const Outcome by = script({"slides.lua"});
    EXPECT_THAT(by.out + by.err, HasSubstr("a period of 98 s and priority 0"));
    EXPECT_THAT(by.out + by.err, HasSubstr("in this order"));
}

TEST_F(LuaDeployer, XmlComponentsRunLuaScripts) {
    write("hooks.lua", "function startHook() print('started by lua') return true end");
    write("app.xml",
          "<?xml version=\"1.0\"?>\n<properties>\n"
          "<simple name=\"Import\" type=\"string\"><value>ocl</value></simple>\n"
          "<struct name=\"c\" type=\"OCL::LuaComponent\">\n"
          "<simple name=\"AutoConf\" type=\"boolean\"><value>1</value></simple>\n"
          "<simple name=\"AutoStart\" type=\"boolean\"><value>1</value></simple>\n"
          "<struct name=\"Properties\" type=\"PropertyBag\">\n"
          "<simple name=\"lua_file\" type=\"string\"><value>hooks.lua</value></simple>\n"
          "</struct>\n</struct>\n"
          "<struct name=\"h\" type=\"OCL::HelloWorld\">\n"
          "<simple name=\"RunScript\" type=\"string\"><value>run.lua</value></simple>\n</struct>\n"
          "</properties>\n");
    write("run.lua", "print('owner is ' .. rtt.getTC():getName())");
    const Outcome by = script({"app.xml"});
    EXPECT_EQ(0, by.status) << by.out + by.err;
    EXPECT_THAT(by.out + by.err, HasSubstr("started by lua"));
    EXPECT_THAT(by.out + by.err, HasSubstr("owner is h"));
    write("run.lua", "function configureHook() print('configured by lua') return true end");
    write("own.xml",
          "<?xml version=\"1.0\"?>\n<properties>\n"
          "<simple name=\"Import\" type=\"string\"><value>ocl</value></simple>\n"
          "<struct name=\"c\" type=\"OCL::LuaComponent\">\n"
          "<simple name=\"RunScript\" type=\"string\"><value>run.lua</value></simple>\n"
          "<simple name=\"AutoConf\" type=\"boolean\"><value>1</value></simple>\n</struct>\n</properties>\n");
    const Outcome own = script({"own.xml"});
    EXPECT_EQ(0, own.status) << own.out + own.err;
    EXPECT_THAT(own.out + own.err, HasSubstr("configured by lua"));
    write("run.lua", "x = = 1");
    const Outcome check = deploy({"--check", "app.xml"});
    EXPECT_NE(0, check.status);
    EXPECT_THAT(check.out + check.err, HasSubstr("run.lua:1:"));
}

TEST_F(LuaDeployer, CheckCompilesAndExecutesNothing) {
    write("good.lua", "print('executed') error('never')");
    const Outcome good = deploy({"--check", "good.lua"});
    EXPECT_EQ(0, good.status) << good.out + good.err;
    EXPECT_THAT(good.out + good.err, testing::Not(HasSubstr("executed")));
    write("bad.lua", "x = 1\nend");
    const Outcome bad = deploy({"--check", "bad.lua"});
    EXPECT_NE(0, bad.status);
    EXPECT_THAT(bad.out + bad.err, HasSubstr("bad.lua:2:"));
}

TEST_F(LuaDeployer, TheConsoleExecutesFilesAndCode) {
    write("a.lua", "x = 20 print('file of ' .. rtt.getTC():getName())");
    oroforge::test::Command console = command({});
    console.input = ".lua a.lua\n.lua print('sum', x + 1)\n.lua error('on purpose')\n.lua\n";
    const Outcome by = oroforge::test::run(console);
    EXPECT_THAT(by.out + by.err, HasSubstr("file of Deployer"));
    EXPECT_THAT(by.out + by.err, HasSubstr("sum\t21"));
    EXPECT_THAT(by.out + by.err, HasSubstr("on purpose"));
    EXPECT_THAT(by.out + by.err, HasSubstr("expected code of Lua"));
}

#ifdef WITH_RT_CHECK
TEST_F(LuaDeployer, RealTimeChecksNameTheLuaLine) {
    write("loop.lua",
          "function updateHook()\n"
          "  n = (n or 0) + 1\n"
          "  local t = {n}\n"
          "  if n == 50 then print('all is done') io.stdout:flush() end\n"
          "end\n");
    write("app.lua",
          "local d = rtt.getTC()\n"
          "d:import('ocl')\n"
          "d:loadComponent('c', 'OCL::LuaComponent')\n"
          "local c = d:getPeer('c')\n"
          "d:getOperation('setActivity')('c', 0.001, 10, rtt.globals_get('ORO_SCHED_RT'))\n"
          "assert(c:getOperation('exec_file')('loop.lua'))\n"
          "c:configure() c:start()\n");
    const Outcome by = runUntil("all is done", {"--rt-check", "-s", "app.lua"}, SIGTERM);
    EXPECT_THAT(by.err, HasSubstr("loop.lua:3: error: [RTC001] component 'c' allocates memory in updateHook()"));
}

TEST_F(LuaDeployer, RealTimeChecksFindNothingInAComponentWithAPool) {
    write("sum.lua",
          "local out = rtt.OutputPort('double', 'out') rtt.getTC():addPort(out)\n"
          "local total = 0\n"
          "function updateHook()\n"
          "  total = total + 0.5\n"
          "  local sample = {total}\n"
          "  out:write(sample[1])\n"
          "end\n");
    write("watch.lua", "function updateHook() print('all is done') io.stdout:flush() end\n");
    write("app.lua",
          "local d = rtt.getTC()\n"
          "d:import('ocl')\n"
          "local function load(name, type, file, period, priority, scheduler)\n"
          "  d:loadComponent(name, type)\n"
          "  local c = d:getPeer(name)\n"
          "  d:setActivity(name, period, priority, rtt.globals_get(scheduler))\n"
          "  assert(c:exec_file(file) and c:configure())\n"
          "  return c\n"
          "end\n"
          "local sum = load('sum', 'OCL::LuaTLSFComponent', 'sum.lua', 0.001, 10, 'ORO_SCHED_RT')\n"
          "sum:getProperty('lua_gc_budget'):set(0.0001)\n"
          "assert(sum:start())\n"
          "rtt.sleep(0.5)\n"
          "assert(load('watch', 'OCL::LuaComponent', 'watch.lua', 0.1, 0, 'ORO_SCHED_OTHER'):start())\n");
    const Outcome by = runUntil("all is done", {"--rt-check", "-s", "app.lua"}, SIGTERM);
    EXPECT_THAT(by.err, HasSubstr("--rt-check: 0 findings in "));
}
#endif

TEST_F(LuaDeployer, ASignalEndsAnEndlessScript) {
    write("loop.lua", "print('looping') io.stdout:flush() while true do pcall(function() while true do end end) end");
    const Outcome by = runUntil("looping", {"-s", "loop.lua"}, SIGTERM);
    EXPECT_THAT(by.out + by.err, HasSubstr("interrupted"));
}

}  // namespace
