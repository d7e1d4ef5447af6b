// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a cycle of a Lua component with a pool asks of the system: nothing.
#include "lua_fixture.hpp"

#include <ocl/LuaTLSFComponent.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>

#include <support/real_time_trap.hpp>

namespace {

using oroforge::test::RealTimeTrap;

class LuaRealTime : public components_test::WithLibrary {};

TEST_F(LuaRealTime, ACycleAllocatesNothingAndWaitsForNothing) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    OCL::LuaTLSFComponent component("pooled");
    component.setActivity(new RTT::extras::SlaveActivity(0.001));
    ASSERT_TRUE(
        component.exec_str("local tc = rtt.getTC()\n"
                           "a = rtt.InputPort.new('double', 'a') tc:addPort(a)\n"
                           "b = rtt.InputPort.new('double', 'b') tc:addPort(b)\n"
                           "sum = rtt.OutputPort.new('double', 'sum') tc:addPort(sum)\n"
                           "local period = tc:getOperation('getPeriod')\n"
                           "function updateHook()\n"
                           "  local sa, x = a:read() local sb, y = b:read()\n"
                           "  local t = {x, y, name = 'n' .. tostring(x)}\n"
                           "  if sa ~= 'NoData' and sb ~= 'NoData' then sum:write(t[1] + t[2] + period() * 0) end\n"
                           "end"));
    RTT::OutputPort<double> a("a"), b("b");
    RTT::InputPort<double> sum("sum");
    ASSERT_TRUE(a.connectTo(component.getPort("a")));
    ASSERT_TRUE(b.connectTo(component.getPort("b")));
    ASSERT_TRUE(sum.connectTo(component.getPort("sum")));
    RTT::Property<double>(component.getProperty("lua_gc_budget")).set(100e-6);
    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    for (int i = 0; i != 100; ++i) component.update();
    for (int i = 0; i != 2000; ++i) {
        a.write(i);
        b.write(1);
        // The mutexes of the interpreter and of the pool are free, and inherit priority.
        oroforge::test::expectRealTime([&] { component.update(); },
                                       RealTimeTrap::kAllocation | RealTimeTrap::kRelease | RealTimeTrap::kWait);
        double read = 0;
        ASSERT_EQ(RTT::NewData, sum.read(read));
        ASSERT_EQ(i + 1, read);
    }
}

}  // namespace
