// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Time to load a generated typekit of 200 structs, with their sequences, into a process that knows the built-in types.
#include "child.hpp"
#include "pairs.hpp"

#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/Types.hpp>

namespace {

/** Milliseconds; 0 if it failed. */
double importTime() {
    return bench::inChild([] {
        bool loaded = false;
        const double seconds = bench::timed(CLOCK_MONOTONIC, [&] {
            loaded = RTT::plugin::PluginLoader::Instance()->loadLibrary(MEASURED_TYPEKIT_FILE);
        });
        return loaded && RTT::types::Types()->type("/measured/Sample199") ? seconds * 1e3 : 0.0;
    });
}

void typekitImport(benchmark::State& state) {
    if (!RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE))
        return state.SkipWithError("no built-in types");
    std::vector<double> times;
    for (auto _ : state) {
        const double time = importTime();
        if (time <= 0) return state.SkipWithError("the typekit was not loaded");
        times.push_back(time);
        state.SetIterationTime(time / 1e3);
    }
    state.counters["ms"] = bench::median(times);
    state.counters["target_ms"] = 10;
}
BENCHMARK(typekitImport)
    ->Name("types/import, 200 generated structs")
    ->Iterations(bench::kPairs)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
