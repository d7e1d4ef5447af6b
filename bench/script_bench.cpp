// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Scripts: a statement of a running program, a cycle of a state machine, evaluating a line, loading a program.
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/scripting/ScriptingService.hpp>

#include <benchmark/benchmark.h>

#include <malloc.h>
#include <string>

namespace {

using namespace RTT;

constexpr double kStatementNs = 8, kCycleNs = 60, kStepNs = 60, kEvalUs = 10, kLoadMs = 3, kStatementBytes = 400;
constexpr int kStatements = 1000, kStopped = 18;

/** Steps when it is told to. */
class Component : public TaskContext {
public:
    Component() : TaskContext("component") {
        static const bool loaded = plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE);
        benchmark::DoNotOptimize(loaded);
        setActivity(new extras::SlaveActivity());
        addAttribute("cnt", cnt_);
        scripting = scripting::ScriptingService::Create(this);
        scripting->eval("scripting.ZeroPeriodWarning = false");
        start();
    }
    ~Component() override { stop(); }

    scripting::ScriptingService::shared_ptr scripting;

private:
    int cnt_ = 0;
};

std::string program(int statements) {
    std::string text = "program p {\n  var double x = 1.0, y = 2.0\n  while (true) {\n";
    for (int i = 0; i != statements; ++i) text += "    x = x * 0.5 + y\n";
    return text + "    yield\n  }\n}\n";
}

void statement(benchmark::State& state) {
    Component component;
    if (!component.scripting->loadProgramText(program(kStatements)) || !component.scripting->startProgram("p"))
        return state.SkipWithError("the program does not run");
    for (auto round : state) {
        (void)round;
        component.update();
    }
    state.SetItemsProcessed(state.iterations() * kStatements);
    state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * kStatements * 1e-9,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["target_ns"] = kStatementNs;
}

/** Calls `step(component, machine)` with a machine that stays in its state, and programs that are stopped. */
template <class Step>
void withMachine(benchmark::State& state, Step step, int programs = 0) {
    Component component;
    for (int i = 0; i != programs; ++i) {
        if (!component.scripting->loadProgramText("program p" + std::to_string(i) + " { cnt = cnt + 1 }"))
            return state.SkipWithError("not loaded");
        component.update();
    }
    const bool running = component.scripting->loadStateMachineText(
                             "StateMachine M {\n  var int n\n  initial state A {\n    run { n = n + 1 }\n"
                             "    transitions { if n < 0 then select B }\n  }\n  final state B { }\n}\n"
                             "RootMachine M m\n") &&
                         component.scripting->activateStateMachine("m") && component.scripting->startStateMachine("m");
    if (!running) return state.SkipWithError("the state machine does not run");
    component.update();
    scripting::StateMachine& machine = *component.scripting->getStateMachine("m");
    for (auto round : state) {
        (void)round;
        step(component, machine);
    }
}

void cycle(benchmark::State& state) {
    withMachine(state, [](Component&, scripting::StateMachine& machine) { machine.execute(); });
    state.counters["target_ns"] = kCycleNs;
}

void step(benchmark::State& state) {
    withMachine(state, [](Component& component, scripting::StateMachine&) { component.update(); });
}

/** The same with programs that are loaded and do not run. */
void stepWithStopped(benchmark::State& state) {
    withMachine(
        state, [](Component& component, scripting::StateMachine&) { component.update(); },
        static_cast<int>(state.range(0)));
    if (state.range(0) == kStopped) state.counters["target_ns"] = kStepNs;
}

/** What is in the above without a machine. */
void emptyStep(benchmark::State& state) {
    Component component;
    for (auto round : state) {
        (void)round;
        component.update();
    }
}

void eval(benchmark::State& state) {
    Component component;
    const std::string line = "cnt = 1 + 2*3";
    for (auto round : state) {
        (void)round;
        if (!component.scripting->eval(line)) return state.SkipWithError("not evaluated");
    }
    state.counters["target_us"] = kEvalUs;
}

void load(benchmark::State& state) {
    Component component;
    const std::string text = program(static_cast<int>(state.range(0)));
    for (auto round : state) {
        (void)round;
        if (!component.scripting->loadProgramText(text)) return state.SkipWithError("not loaded");
        component.scripting->unloadProgram("p");
        component.update();
    }
    if (state.range(0) == kStatements) state.counters["target_ms"] = kLoadMs;
}

void memory(benchmark::State& state) {
    const std::string text = program(kStatements);
    double bytes = 0;
    for (auto round : state) {
        (void)round;
        Component component;
        const auto before = mallinfo2().uordblks;
        if (!component.scripting->loadProgramText(text)) return state.SkipWithError("not loaded");
        bytes = static_cast<double>(mallinfo2().uordblks - before) / kStatements;
    }
    state.counters["bytes"] = bytes;
    state.counters["target_bytes"] = kStatementBytes;
}

BENCHMARK(statement)->Name("script/1000 statements of a program");
BENCHMARK(cycle)->Name("script/cycle of a state machine");
BENCHMARK(step)->Name("script/step of a component with a state machine");
BENCHMARK(stepWithStopped)
    ->Name("script/step of a component with a state machine and stopped programs")
    ->Arg(kStopped)
    ->Arg(10 * kStopped);
BENCHMARK(emptyStep)->Name("script/step of a component without");
BENCHMARK(eval)->Name("script/eval(\"cnt = 1 + 2*3\")")->Unit(benchmark::kMicrosecond);
BENCHMARK(load)->Name("script/load")->Arg(100)->Arg(kStatements)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(memory)->Name("script/memory of a statement")->Iterations(5)->Unit(benchmark::kMillisecond);

}  // namespace
