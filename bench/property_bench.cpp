// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Property files: reading into a component's properties and writing them, whole and into a file that exists. Half of
// the properties are numbers, the others texts, bools and sequences of three numbers.
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/marsh/PropertyLoader.hpp>
#include <rtt/os/startstop.h>
#include <rtt/plugin/PluginLoader.hpp>

#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>
#include <vector>

using namespace RTT;

namespace {

const char* const kFile = "property_bench.cpf";
constexpr double kTargetMs = 5;  // of 1000 properties

/** A component with that many properties. */
class Component : public TaskContext {
public:
    explicit Component(long count) : TaskContext("component") {
        for (long i = 0; i != count; ++i) properties()->ownProperty(make(i));
    }

private:
    static base::PropertyBase* make(long i) {
        const std::string name = "property" + std::to_string(i), text = "what this property is for";
        if (i % 2 == 0) return new Property<double>(name, text, 0.1 * static_cast<double>(i));
        if (i % 8 == 1) return new Property<std::vector<double>>(name, text, {1, 2, 3});
        if (i % 8 == 3) return new Property<bool>(name, text, true);
        return new Property<std::string>(name, text, "some words of text");
    }
};

/** Runs `step(loader)`, which returns false if it failed, on a component and its file. */
template <class Step>
void onFile(benchmark::State& state, Step step) {
    Component component(state.range(0));
    const marsh::PropertyLoader loader(&component);
    if (!loader.store(kFile)) state.SkipWithError("the file was not written");
    for (auto round : state) {
        (void)round;
        if (!step(loader)) state.SkipWithError("it failed");
    }
    std::remove(kFile);
}

void setTarget(benchmark::State& state) {
    if (state.range(0) == 1000) state.counters["target_ms"] = kTargetMs;
}

void read(benchmark::State& state) {
    onFile(state, [](const marsh::PropertyLoader& loader) { return loader.configure(kFile, true); });
    setTarget(state);
}

void store(benchmark::State& state) {
    onFile(state, [](const marsh::PropertyLoader& loader) { return loader.store(kFile); });
    setTarget(state);
}

/** Reads the file, too. */
void writeIntoFile(benchmark::State& state) {
    onFile(state, [](const marsh::PropertyLoader& loader) { return loader.save(kFile, true); });
}

/** Values from one bag into another of the same properties. */
void refresh(benchmark::State& state) {
    Component target(state.range(0)), source(state.range(0));
    for (auto round : state) {
        (void)round;
        benchmark::DoNotOptimize(refreshProperties(*target.properties(), *source.properties(), true));
    }
}

BENCHMARK(read)->Name("properties/read")->Arg(10)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(store)->Name("properties/store")->Arg(10)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(writeIntoFile)->Name("properties/write_into_file")->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(refresh)->Name("properties/refresh")->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/** The runtime and the built-in types around the benchmarks. */
struct Runtime {
    Runtime() {
        static char name[] = "property_bench";
        static char* words[] = {name, nullptr};
        __os_init(1, words);
        if (!plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE)) std::fputs("no built-in types\n", stderr);
    }
    ~Runtime() { __os_exit(); }
} runtime;

}  // namespace
