// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Bad scripts: each is reported with its place, and nothing crashes.
#include "lua_fixture.hpp"

#include <ocl/HelloWorld.hpp>
#include <rtt/OutputPort.hpp>

#include <chrono>

namespace {

using namespace lua_test;
using testing::HasSubstr;

class LuaFault : public LuaTest {
protected:
    /** The log of code that has to fail. */
    std::string failure(const std::string& code) {
        return logged([&] { EXPECT_FALSE(run(code)) << code; });
    }
};

TEST_F(LuaFault, SyntaxErrorsHaveALine) { EXPECT_THAT(failure("x = 1\ny = = 2"), HasSubstr(":2: ")); }

TEST_F(LuaFault, AnErrorThatIsNoTextIsReported) {
    EXPECT_THAT(failure("error({})"), HasSubstr("error object is a table value"));
}

TEST_F(LuaFault, DeletedPortsCanBeAskedForNothing) {
    ASSERT_TRUE(run("p = rtt.OutputPort.new('int', 'p') rtt.getTC():addPort(p) q = rtt.getTC():getPort('p')"));
    ASSERT_TRUE(run("p:delete()"));
    EXPECT_EQ(nullptr, component.getPort("p"));
    EXPECT_THAT(failure("p:write(1)"), HasSubstr("was deleted"));
    EXPECT_THAT(failure("q:write(1)"), HasSubstr("no longer"));
    EXPECT_EQ("deleted OutputPort", value("p"));
}

TEST_F(LuaFault, DestroyedComponentsAreNoticed) {
    {
        OCL::HelloWorld peer("peer");
        component.addPeer(&peer);
        ASSERT_TRUE(
            run("peer = rtt.getTC():getPeer('peer') op = peer:getOperation('the_method')\n"
                "port = peer:getPort('the_results') prop = peer:getProperty('the_property')\n"
                "attr = peer:getAttribute('the_attribute') svc = peer:provides() raw = prop:getRaw()"));
    }
    for (const char* code : {"peer:getState()", "op()", "op:send()", "port:info()", "prop:get()", "prop:set('x')",
                             "attr:get()", "svc:getName()", "raw:tolua()", "raw:assign('x')", "peer:the_method()"})
        EXPECT_THAT(failure(code), HasSubstr("destroyed")) << code;
}

TEST_F(LuaFault, AnEndlessLoopInAHookEndsAtTheTimeLimit) {
    set("lua_timeout", 0.1);
    ASSERT_TRUE(run("function updateHook() while true do end end"));
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    const auto start = std::chrono::steady_clock::now();
    const std::string log = logged([this] { component.update(); });
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
    EXPECT_THAT(log, HasSubstr("time limit"));
    EXPECT_EQ(RTT::TaskContext::Exception, component.getTaskState());
}

TEST_F(LuaFault, NoPcallOutlivesTheTimeLimit) {
    set("lua_timeout", 0.1);
    ASSERT_TRUE(run("function startHook() while true do pcall(function() while true do end end) end end"));
    ASSERT_TRUE(component.configure());
    EXPECT_FALSE(component.start());
}

TEST_F(LuaFault, TimeInOperationsIsNotCounted) {
    set("lua_timeout", 0.05);
    ASSERT_TRUE(run("function configureHook() rtt.sleep(0, 200e6) for i = 1, 1e5 do end return true end"));
    EXPECT_TRUE(component.configure());
}

TEST_F(LuaFault, EndlessRecursionFails) {
    EXPECT_THAT(failure("local function f() return 1 + f() end f()"), HasSubstr("stack overflow"));
    ASSERT_TRUE(
        run("local tc = rtt.getTC() tc:addOperation('again', 'void()', function() tc:getOperation('again')() end)"));
    EXPECT_THAT(failure("rtt.getTC():getOperation('again')()"), HasSubstr("too deeply"));
}

TEST_F(LuaFault, WrongArgumentsAreNamed) {
    EXPECT_THAT(failure("rtt.Variable.new('int', 'x')"), HasSubstr("int"));
    EXPECT_THAT(failure("rtt.Variable.new('uint8', 300)"), HasSubstr("cannot hold 300"));
    EXPECT_THAT(failure("rtt.Variable.new('int', 0/0)"), HasSubstr("cannot hold"));
    EXPECT_THAT(failure("rtt.Variable.new('nonsense')"), HasSubstr("'nonsense'"));
    EXPECT_THAT(failure("rtt.getTC():getOperation('start')(1)"), HasSubstr("it takes 0 arguments, not 1"));
    EXPECT_THAT(failure("rtt.getTC():getOperation('nope')"), HasSubstr("'nope'"));
    EXPECT_THAT(failure("rtt.InputPort.read(7)"), HasSubstr("InputPort"));
    EXPECT_THAT(failure("rtt.InputPort.read(io.stdout)"), HasSubstr("InputPort"));
    EXPECT_THAT(failure("rtt.TaskContext.getName()"), HasSubstr("TaskContext"));
    EXPECT_THAT(failure("rtt.getTC():addPort(rtt.InputPort.new('int'))"), HasSubstr("name"));
    EXPECT_THAT(failure("rtt.setLogLevel('Loud')"), HasSubstr("'Loud'"));
    EXPECT_THAT(failure("rtt.getTC():addOperation('x', 'nonsense(int)', print)"), HasSubstr("nonsense"));
    EXPECT_THAT(failure("rtt.getTC():addOperation('start', 'void()', print)"), HasSubstr("already"));
}

TEST_F(LuaFault, ManyArgumentsAndValuesHaveRoom) {
    ASSERT_TRUE(
        run("local tc, s, v = rtt.getTC(), {}, {}\n"
            "for i = 1, 100 do s[i] = 'int& a' .. i v[i] = i end\n"
            "tc:addOperation('many', 'void(' .. table.concat(s, ',') .. ')', function(...) return ... end, "
            "{thread = 'OwnThread'})\n"
            "local op = tc:getOperation('many')\n"
            "op(unpack(v))\n"
            "handle = op:send(unpack(v))"));
    component.update();
    ASSERT_TRUE(run("local all = {handle:collect()} assert(#all == 101 and all[101] == 100)"));
}

TEST_F(LuaFault, APropertyBelongsToOneComponentOnly) {
    ASSERT_TRUE(run("p = rtt.Property('int', 'a', '') tc = rtt.getTC() tc:addProperty(p)"));
    EXPECT_THAT(failure("tc:addProperty(p, 'b')"), HasSubstr("already"));
    EXPECT_THAT(failure("tc:addProperty(tc:getProperty('a'))"), HasSubstr("has made"));
    ASSERT_TRUE(run("rtt.TaskContext.getProperty(tc, 'a'):delete()"));
    EXPECT_THAT(failure("tc:addProperty(p)"), HasSubstr("was deleted"));
    EXPECT_EQ(nullptr, component.getProperty("a"));
}

TEST_F(LuaFault, PortsOfOthersAreNotTaken) {
    OCL::HelloWorld peer("peer");
    component.addPeer(&peer);
    EXPECT_THAT(failure("rtt.getTC():addPort(rtt.getTC():getPeer('peer'):getPort('the_results'))"),
                HasSubstr("has made"));
    EXPECT_NE(nullptr, peer.getPort("the_results"));
}

TEST_F(LuaFault, NoHookOfTheDebugLibraryOutlivesItsCode) {
    set("lua_timeout", 0.1);
    ASSERT_TRUE(run("debug.sethook() function updateHook() while true do end end"));
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    component.update();
    EXPECT_EQ(RTT::TaskContext::Exception, component.getTaskState());
}

TEST_F(LuaFault, TheServiceNeedsAComponent) {
    EXPECT_FALSE(run("assert(rtt.provides('Lua'))"));
    (void)run("rtt.provides():getOperation('require')('Lua')");
}

TEST_F(LuaFault, MetamethodsAndFinalizersStandNonsense) {
    // What Lua code finds with debug and getmetatable().
    const char* const attacks[] = {
        "getmetatable(rtt.Variable.new('int')).__gc(5)",
        "local v = rtt.Variable.new('int') local gc = getmetatable(v).__gc gc(v) gc(v)",
        "local v = rtt.Variable.new('int') getmetatable(v).__gc(v) return v:tolua()",
        "local p = rtt.InputPort.new('int', 'x') getmetatable(p).__gc(p) p:read()",
        "local v = rtt.Variable.new('int') local m = getmetatable(v) debug.setmetatable(v, {})"
        " pcall(function() return v.x end) debug.setmetatable(v, m)",
        "debug.setmetatable(newproxy(), getmetatable(rtt.Variable('int'))).x = 1",
        "local v = rtt.Variable('int') local l = v:tolud() debug.setmetatable(l, getmetatable(v)) return l.x",
        "local tc = rtt.getTC() tc:addOperation('g', 'void()', function() getmetatable(op).__gc(op) end)"
        " op = tc:getOperation('g') op()",
        "rtt.operations_first() local tc = rtt.getTC() p = newproxy(true)"
        " getmetatable(p).__gc = function() tc:isRunning() end tc:isRunning() p = nil tc = nil collectgarbage()",
        "rtt.operations_first() local tc = rtt.getTC() q = newproxy(true)"
        " getmetatable(q).__gc = function() tc:isRunning() end tc:isRunning()",
        "local v = rtt.Variable.new('array') v:resize(-1) v:resize(1e300) v:resize(0/0)",
        "local v = rtt.Variable.new('array') return v[-1]",
        "local v = rtt.Variable.new('array') v:resize(2) v[1e18] = 1",
        "setmetatable(_G, {__index = function() error('no') end}) undefined()",
    };
    for (const char* attack : attacks) (void)logged([&] { (void)run(attack); });
    EXPECT_EQ("5", value("rtt.Variable.new('int', 5):tolua()"));
}

}  // namespace
