// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The memory of interpreters: pools, garbage collection within a budget, no growth.
#include "lua_fixture.hpp"

#include <ocl/LuaTLSFComponent.hpp>
#include <rtt/OperationCaller.hpp>

#include <fstream>

namespace {

using namespace lua_test;
using testing::HasSubstr;

class LuaMemory : public LuaTest {
protected:
    double bytes() { return std::stod(value("collectgarbage('count') * 1024")); }
};

TEST_F(LuaMemory, CreatingAndCollectingDoesNotGrow) {
    const std::string round =
        "for i = 1, 20000 do local v = rtt.Variable.new('ConnPolicy') v.size = i "
        "local p = rtt.InputPort.new('int') local q = rtt.Property.new('string', 'x') local o = "
        "rtt.getTC():getOperation('start') end "
        "collectgarbage() collectgarbage()";
    ASSERT_TRUE(run(round));
    const double before = bytes();
    for (int i = 0; i != 3; ++i) ASSERT_TRUE(run(round));
    EXPECT_LT(bytes(), before + 20000);
}

TEST_F(LuaMemory, AComponentNeedsLessThan150Kilobytes) {
    ASSERT_TRUE(run("pcall(require, 'rttlib') collectgarbage()"));
    EXPECT_LT(bytes(), 150 * 1024);
}

TEST_F(LuaMemory, GarbageIsCollectedWithinTheBudget) {
    set("lua_gc_budget", 200e-6);
    ASSERT_TRUE(run("function updateHook() for i = 1, 100 do local t = {i} end end"));
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    for (int i = 0; i != 3000; ++i) component.update();
    EXPECT_LT(bytes(), 500 * 1024);
    RTT::OperationCaller<std::string()> statistics(component.getOperation("lua_statistics"));
    EXPECT_THAT(statistics(), HasSubstr("longest pause"));
    EXPECT_THAT(statistics(), testing::Not(HasSubstr(" 0 collections")));
}

class LuaPool : public components_test::WithLibrary {
protected:
    OCL::LuaTLSFComponent component{"pooled"};
};

TEST_F(LuaPool, TellsWhatIsInUse) {
    EXPECT_TRUE(
        component.exec_str("local s = tlsf.stats() assert(s.used > 0 and s.total >= 2^21 and s.max >= s.used)"));
}

TEST_F(LuaPool, AFullPoolFailsTheCodeAndNotTheComponent) {
    EXPECT_FALSE(component.exec_str("local t = {} for i = 1, 1e7 do t[i] = {i} end"));
    EXPECT_FALSE(component.exec_str("local s = ('x'):rep(2^23)"));
    EXPECT_TRUE(component.exec_str("collectgarbage() x = 1 rtt.Variable.new('string', 'abc')"));
    ASSERT_TRUE(
        component.exec_str("function updateHook() keep = keep or {} keep[#keep + 1] = ('x'):rep(1000) .. #keep end"));
    ASSERT_TRUE(component.configure());
    component.setActivity(new RTT::extras::SlaveActivity(0.001));
    ASSERT_TRUE(component.start());
    for (int i = 0; i != 5000 && component.isRunning(); ++i) component.update();
    EXPECT_EQ(RTT::TaskContext::Exception, component.getTaskState());
}

TEST_F(LuaPool, CodeThatCatchesTheErrorGoesOn) {
    EXPECT_TRUE(
        component.exec_str("for i = 1, 20 do pcall(function() local s while true do s = {s} end end) end\n"
                           "local t = {} for i = 1, 1000 do t[i] = {} end"));
}

TEST_F(LuaPool, GrowsOnRequestOnly) {
    EXPECT_FALSE(component.exec_str("big = ('x'):rep(3 * 2^20)"));
    EXPECT_TRUE(component.tlsf_incmem(16u << 20));
    EXPECT_TRUE(component.exec_str("big = ('x'):rep(3 * 2^20) assert(tlsf.stats().total > 16 * 2^20)"));
    EXPECT_FALSE(component.tlsf_incmem(0));
}

}  // namespace
