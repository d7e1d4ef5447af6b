// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// NetCDF files of many ports of doubles: the processor time of all threads per row, and a run at 1 kHz.
#include "reporting_setup.hpp"

#include <ocl/NetcdfReporting.hpp>

#include <ctime>
#include <fstream>

namespace {

using namespace reporting_bench;

const char* const kFile = "netcdf_bench.nc";

/** The number of rows in the head of the file. */
long records(const char* name) {
    std::ifstream file(name);
    char head[12] = {};
    file.read(head, sizeof head);
    long number = 0;
    for (int i = 4; i != 12; ++i) number = number * 256 + static_cast<unsigned char>(head[i]);
    return number;
}

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/** Rows in a NetCDF file, from the first to the last byte; the processor time of all threads per row. */
void WholeNetcdf(benchmark::State& state) {
    constexpr int kRows = 5000;
    Setup<OCL::NetcdfReporting> setup(state.range(0), kFile);
    setup.reporter.setActivity(new RTT::extras::SlaveActivity(0.001));
    double used = 0;
    for (auto _ : state) {
        if (!setup.reporter.start()) std::abort();
        setup.write();
        const double before = processorSeconds();
        for (int i = 0; i < kRows; ++i) setup.reporter.update();
        setup.reporter.stop();
        used += processorSeconds() - before;
        if (records(kFile) + setup.lost() != kRows + 1) state.SkipWithError("rows are missing");
    }
    state.counters["us_per_row"] = used * 1e6 / static_cast<double>(state.iterations() * kRows);
}
BENCHMARK(WholeNetcdf)->Arg(200)->Unit(benchmark::kMillisecond)->UseRealTime();

/** The promise: 200 doubles at 1 kHz, no row lost; for 60 seconds with OROFORGE_BENCH_SECONDS=60. */
void NetcdfAtOneKilohertz(benchmark::State& state) { atOneKilohertz<OCL::NetcdfReporting>(state, kFile, &records); }
BENCHMARK(NetcdfAtOneKilohertz)->Arg(200)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
