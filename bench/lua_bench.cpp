// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What Lua code pays for C++: calls, ports, a whole cycle; and the memory of a component.
#include <ocl/LuaComponent.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <malloc.h>
#include <memory>

namespace {

double add(double a, double b) { return a + b; }

/** A component with ports `a` and `b` to read, `sum` to write, and an operation. */
class Component {
public:
    Component() {
        static const bool loaded = RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE);
        if (!loaded) std::abort();
        lua.setActivity(new RTT::extras::SlaveActivity(0.001));
        lua.addOperation("add", &add);
        run("local tc = rtt.getTC()\n"
            "a = rtt.InputPort.new('double', 'a') tc:addPort(a)\n"
            "b = rtt.InputPort.new('double', 'b') tc:addPort(b)\n"
            "sum = rtt.OutputPort.new('double', 'sum') tc:addPort(sum)\n"
            "op = tc:getOperation('add')");
        a.connectTo(lua.getPort("a"));
        b.connectTo(lua.getPort("b"));
        sum.connectTo(lua.getPort("sum"));
        a.write(1);
        b.write(2);
    }
    void run(const std::string& code) {
        if (!lua.exec_str(code)) std::abort();
    }
    /** Measures `statement`, executed in a loop of Lua. */
    void measure(benchmark::State& state, const std::string& statement, double target) {
        constexpr int kRounds = 1000;
        run("local a, b, sum, op, tc = a, b, sum, op, rtt.getTC() rtt.operations_first()\n"
            "function loop() for i = 1, " +
            std::to_string(kRounds) + " do " + statement + " end end");
        for (auto _ : state) run("loop()");
        state.SetItemsProcessed(state.iterations() * kRounds);
        const auto rounds = static_cast<double>(state.iterations() * kRounds);
        state.counters["us"] =
            benchmark::Counter(rounds * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
        state.counters["target_us"] = target;
    }

    OCL::LuaComponent lua{"lua"};
    RTT::OutputPort<double> a{"a"}, b{"b"};
    RTT::InputPort<double> sum{"sum"};
};

void luaCall(benchmark::State& state) { Component().measure(state, "op(1, 2)", 0.6); }
void luaCallAsMethod(benchmark::State& state) { Component().measure(state, "tc:add(1, 2)", 0.6); }
void luaRead(benchmark::State& state) { Component().measure(state, "local s, x = a:read()", 0.3); }
void luaWrite(benchmark::State& state) { Component().measure(state, "sum:write(i)", 0.3); }

void luaCycle(benchmark::State& state) {
    Component component;
    component.run(
        "local gain, last, low, high = 0.5, 0, -100, 100\n"
        "local steps, total = 0, 0\n"
        "function updateHook()\n"
        "  local sa, x = a:read()\n"
        "  local sb, y = b:read()\n"
        "  if sa == 'NoData' or sb == 'NoData' then return end\n"
        "  steps = steps + 1\n"
        "  local error = x - y\n"
        "  total = total + error\n"
        "  local slope = error - last\n"
        "  last = error\n"
        "  local out = gain * error + 0.1 * total + 0.01 * slope\n"
        "  if out > high then out = high end\n"
        "  if out < low then out = low end\n"
        "  if total > high then total = high end\n"
        "  if total < low then total = low end\n"
        "  local share = math.abs(out) / high\n"
        "  if share > 1 then share = 1 end\n"
        "  sum:write(out)\n"
        "end");
    component.lua.configure();
    component.lua.start();
    for (auto _ : state) component.lua.update();
    state.counters["us"] = benchmark::Counter(static_cast<double>(state.iterations()) * 1e-6,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["target_us"] = 10;
}

void luaMemory(benchmark::State& state) {
    constexpr int kComponents = 50;
    double bytes = 0;
    for (auto _ : state) {
        std::vector<std::unique_ptr<OCL::LuaComponent>> all;
        const auto before = mallinfo2().uordblks;
        for (int i = 0; i != kComponents; ++i) {
            all.push_back(std::make_unique<OCL::LuaComponent>("c" + std::to_string(i)));
            if (!all.back()->exec_str("pcall(require, 'rttlib') collectgarbage()")) std::abort();
        }
        bytes = static_cast<double>(mallinfo2().uordblks - before) / kComponents;
    }
    state.counters["bytes"] = bytes;
    state.counters["target_bytes"] = 150 * 1024;
}

BENCHMARK(luaCall);
BENCHMARK(luaCallAsMethod);
BENCHMARK(luaRead);
BENCHMARK(luaWrite);
BENCHMARK(luaCycle);
BENCHMARK(luaMemory)->Iterations(1);

}  // namespace
