// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reports of many ports of doubles: what a row costs the reporter's thread and the one that writes, and runs at 1 kHz.
#include <ocl/FileReporting.hpp>
#include <ocl/NetcdfReporting.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/startstop.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <dlfcn.h>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

const char* const kFile = "reporting_bench.dat";
const char* const kNetcdf = "reporting_bench.nc";

void startRuntime() {
    static const bool once = [] {
        RTT::Logger::Instance()->setLogLevel(RTT::Never);  // rows that come without pause may find no room
        static char name[] = "reporting_bench";
        static char* words[] = {name, nullptr};
        void* const library = dlopen(RTT_TYPEKIT_FILE, RTLD_NOW);
        if (__os_init(1, words) != 0 || !library) std::abort();
        return reinterpret_cast<bool (*)(void*)>(dlsym(library, "loadRTTPlugin"))(nullptr);
    }();
    if (!once) std::abort();
}

/** A component with that many ports, and a reporter of them. */
template <class Reporter>
class Setup {
public:
    Setup(long ports, const char* file) : file_(file) {
        startRuntime();
        for (long i = 0; i < ports; ++i) {
            ports_.push_back(std::make_unique<RTT::OutputPort<double>>("port" + std::to_string(i)));
            component_.addPort(*ports_.back());
        }
        reporter.addPeer(&component_);
        RTT::Property<std::string>(reporter.getProperty("ReportFile")).set(file_);
        if (!reporter.reportComponent("component")) std::abort();
    }
    ~Setup() { std::remove(file_); }

    void write() {
        value_ += 0.123456;
        for (const auto& port : ports_) port->write(value_);
    }
    long lines() const {
        std::ifstream file(file_);
        return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
    }
    /** As the head of a NetCDF file has it. */
    long records() const {
        std::ifstream file(file_);
        char head[12] = {};
        file.read(head, sizeof head);
        long number = 0;
        for (int i = 4; i != 12; ++i) number = number * 256 + static_cast<unsigned char>(head[i]);
        return number;
    }
    unsigned lost() { return RTT::Attribute<unsigned>(reporter.getAttribute("LostRows")).get(); }

private:
    RTT::TaskContext component_{"component"};
    std::vector<std::unique_ptr<RTT::OutputPort<double>>> ports_;
    double value_ = 0;
    const char* const file_;

public:
    Reporter reporter{"reporter"};
};

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
        if (setup.lines() != kRows + 2) state.SkipWithError("rows are missing");
    }
    state.SetItemsProcessed(state.iterations() * kRows);
}
BENCHMARK(WholeReport)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/** Rows in a NetCDF file, from the first to the last byte; the processor time of all threads per row. */
void WholeNetcdf(benchmark::State& state) {
    constexpr int kRows = 5000;
    Setup<OCL::NetcdfReporting> setup(state.range(0), kNetcdf);
    setup.reporter.setActivity(new RTT::extras::SlaveActivity(0.001));
    double used = 0;
    for (auto _ : state) {
        if (!setup.reporter.start()) std::abort();
        setup.write();
        const double before = processorSeconds();
        for (int i = 0; i < kRows; ++i) setup.reporter.update();
        setup.reporter.stop();
        used += processorSeconds() - before;
        if (setup.records() + setup.lost() != kRows + 1) state.SkipWithError("rows are missing");
    }
    state.counters["us_per_row"] = used * 1e6 / static_cast<double>(state.iterations() * kRows);
}
BENCHMARK(WholeNetcdf)->Arg(200)->Unit(benchmark::kMillisecond)->UseRealTime();

/** For OROFORGE_BENCH_SECONDS (2) seconds, in threads of their own. */
template <class Reporter>
void atOneKilohertz(benchmark::State& state, const char* file, long (Setup<Reporter>::*rows)() const) {
    const char* const given = std::getenv("OROFORGE_BENCH_SECONDS");
    const int seconds = given ? std::atoi(given) : 2;
    for (auto _ : state) {
        Setup<Reporter> setup(state.range(0), file);
        RTT::Activity::Options options;
        options.name = "reporter";
        options.scheduler = ORO_SCHED_RT;
        options.priority = 80;
        options.period = 0.001;
        setup.reporter.setActivity(new RTT::Activity(options));
        if (!setup.reporter.start()) std::abort();
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < seconds * 1000; ++i) {
            setup.write();
            std::this_thread::sleep_until(begin + std::chrono::milliseconds(i + 1));
        }
        setup.reporter.stop();
        state.counters["rows"] = static_cast<double>((setup.*rows)());
        state.counters["lost"] = setup.lost();
    }
}

/** The promise: 1,000 ports at 1 kHz. */
void AtOneKilohertz(benchmark::State& state) {
    atOneKilohertz<OCL::FileReporting>(state, kFile, &Setup<OCL::FileReporting>::lines);
}
BENCHMARK(AtOneKilohertz)->Arg(1000)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

/** The promise: 200 doubles at 1 kHz, no row lost; for 60 seconds with OROFORGE_BENCH_SECONDS=60. */
void NetcdfAtOneKilohertz(benchmark::State& state) {
    atOneKilohertz<OCL::NetcdfReporting>(state, kNetcdf, &Setup<OCL::NetcdfReporting>::records);
}
BENCHMARK(NetcdfAtOneKilohertz)->Arg(200)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
