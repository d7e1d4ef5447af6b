// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reports of many ports of doubles: what a row costs the reporter's thread and the one that writes, and runs at 1 kHz.
#include "reporting_setup.hpp"

#include <ocl/FileReporting.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace {

using namespace reporting_bench;

const char* const kFile = "reporting_bench.dat";

long lines(const char* name) {
    std::ifstream file(name);
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
}

/** A row, with new samples in all ports; the thread that writes works beside it. */
void Row(benchmark::State& state) {
    Setup<OCL::FileReporting> setup(state.range(0), kFile);
    setup.reporter.setActivity(new RTT::extras::SlaveActivity(0.001));
    if (!setup.reporter.start()) std::abort();
    for (auto _ : state) {
        state.PauseTiming();
        setup.write();
        state.ResumeTiming();
        setup.reporter.update();
    }
    setup.reporter.stop();
    state.counters["lost"] = setup.lost();
}
BENCHMARK(Row)->Arg(1)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

/** Rows that are written completely, from the first to the last byte in the file. */
void WholeReport(benchmark::State& state) {
    constexpr int kRows = 1000;
    Setup<OCL::FileReporting> setup(state.range(0), kFile);
    setup.reporter.setActivity(new RTT::extras::SlaveActivity(0.001));
    for (auto _ : state) {
        if (!setup.reporter.start()) std::abort();
        for (int i = 0; i < kRows; ++i) {
            setup.write();
            setup.reporter.update();
        }
        setup.reporter.stop();
        if (lines(kFile) != kRows + 2) state.SkipWithError("rows are missing");
    }
    state.SetItemsProcessed(state.iterations() * kRows);
}
BENCHMARK(WholeReport)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

/** The promise: 1,000 ports at 1 kHz. */
void AtOneKilohertz(benchmark::State& state) { atOneKilohertz<OCL::FileReporting>(state, kFile, &lines); }
BENCHMARK(AtOneKilohertz)->Arg(1000)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
