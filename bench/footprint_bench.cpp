// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Memory of components, time and memory of connections.
#include "child.hpp"
#include "pairs.hpp"

#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SequentialActivity.hpp>

#include <cstdio>
#include <malloc.h>
#include <memory>
#include <string>
#include <vector>

using namespace RTT;

namespace {

/** Resident memory of this process in bytes, counted by the kernel page by page; 0 if it does not tell. */
double residentBytes() {
    long kib = 0;
    if (std::FILE* file = std::fopen("/proc/self/smaps_rollup", "r")) {
        char line[256];
        while (std::fgets(line, sizeof line, file) && std::sscanf(line, "Rss: %ld kB", &kib) != 1) {
        }
        std::fclose(file);
    }
    return static_cast<double>(kib) * 1024;
}

/** Bytes on the heap, with what malloc adds. */
double heapBytes() { return static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd); }

constexpr int kComponents = 1000;

double bytesPerComponent(bool ownThread) {
    return bench::inChild([ownThread] {
        std::vector<std::unique_ptr<TaskContext>> components;
        components.reserve(kComponents);
        double before = 0;
        for (int i = 0; i <= kComponents; ++i) {
            if (i == 1) before = residentBytes();  // the first one pays for what all share
            components.push_back(std::make_unique<TaskContext>("component" + std::to_string(i)));
            if (!ownThread) components.back()->setActivity(new extras::SequentialActivity());
            components.back()->start();
        }
        const double each = (residentBytes() - before) / kComponents;
        for (const auto& component : components) component->stop();
        return each;
    });
}

void componentMemory(benchmark::State& state, bool ownThread, double target) {
    std::vector<double> bytes;
    for (auto _ : state) bytes.push_back(bytesPerComponent(ownThread));
    if (bench::median(bytes) <= 0) return state.SkipWithError("the child process did not measure");
    state.counters["bytes"] = bench::median(bytes);
    state.counters["target_bytes"] = target;
}
BENCHMARK_CAPTURE(componentMemory, sequential, false, 25e3)
    ->Name("component/memory, sequential activity")
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(componentMemory, ownThread, true, 45e3)
    ->Name("component/memory, own idle thread")
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

struct Pairs {
    explicit Pairs(int n) {
        for (int i = 0; i < n; ++i) {
            outputs.push_back(std::make_unique<OutputPort<double>>("out"));
            inputs.push_back(std::make_unique<InputPort<double>>("in"));
        }
    }
    bool connect(const ConnPolicy& policy) {
        bool all = true;
        for (std::size_t i = 0; i < outputs.size(); ++i) all = outputs[i]->createConnection(*inputs[i], policy) && all;
        return all;
    }
    void disconnect() {
        for (auto& output : outputs) output->disconnect();
    }
    std::vector<std::unique_ptr<OutputPort<double>>> outputs;
    std::vector<std::unique_ptr<InputPort<double>>> inputs;
};

constexpr int kConnections = 500;

/** Each iteration connects many pairs of ports; only that is timed. */
void connectionTime(benchmark::State& state, const ConnPolicy& policy) {
    Pairs pairs(kConnections);
    std::vector<double> times;
    for (auto _ : state) {
        bool connected = false;
        const double each =
            bench::timed(CLOCK_THREAD_CPUTIME_ID, [&] { connected = pairs.connect(policy); }) / kConnections;
        if (!connected) return state.SkipWithError("not connected");
        times.push_back(each * 1e9);
        state.SetIterationTime(each);
        pairs.disconnect();
    }
    state.counters["ns"] = bench::median(times);
    state.counters["target_ns"] = 3000;
}
BENCHMARK_CAPTURE(connectionTime, data, ConnPolicy::data())
    ->Name("connection/connect, DATA")
    ->Iterations(bench::kPairs)
    ->UseManualTime();
BENCHMARK_CAPTURE(connectionTime, buffer, ConnPolicy::buffer(10))
    ->Name("connection/connect, BUFFER of 10")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

void disconnectionTime(benchmark::State& state) {
    Pairs pairs(kConnections);
    for (auto _ : state) {
        pairs.connect(ConnPolicy::data());
        state.SetIterationTime(bench::timed(CLOCK_THREAD_CPUTIME_ID, [&] { pairs.disconnect(); }) / kConnections);
    }
}
BENCHMARK(disconnectionTime)->Name("connection/disconnect, DATA")->Iterations(bench::kPairs)->UseManualTime();

/** All of it, samples included: four places for a double. */
void connectionMemory(benchmark::State& state) {
    Pairs pairs(kConnections);
    pairs.connect(ConnPolicy::data());  // what the ports themselves allocate once
    pairs.disconnect();
    double bytes = 0;
    for (auto _ : state) {
        const double before = heapBytes();
        pairs.connect(ConnPolicy::data());
        bytes = (heapBytes() - before) / kConnections;
        pairs.disconnect();
    }
    state.counters["bytes"] = bytes;
    state.counters["target_bytes"] = 1024;
}
BENCHMARK(connectionMemory)->Name("connection/memory, DATA of double")->Iterations(3);

}  // namespace
