// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What it costs to bring a sample from an output port to an input port, in one thread.
#include <rtt/Port.hpp>

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

using namespace RTT;

namespace {

struct Bytes64 {
    double numbers[8];
};

template <class T>
T sampleOf() {
    return T();
}
template <>
std::vector<double> sampleOf() {
    return std::vector<double>(1000, 1.0);
}

template <class T>
void roundTrip(benchmark::State& state, const ConnPolicy& policy, bool keepLast) {
    OutputPort<T> out("out", keepLast);
    InputPort<T> in("in");
    T sample = sampleOf<T>(), got = sample;
    out.setDataSample(sample);
    if (!out.createConnection(in, policy)) return state.SkipWithError("not connected");
    for (auto _ : state) {
        benchmark::DoNotOptimize(sample);
        if (out.write(sample) != WriteSuccess || in.read(got) != NewData) return state.SkipWithError("sample lost");
        benchmark::DoNotOptimize(got);
    }
}

void oneToEight(benchmark::State& state) {
    OutputPort<double> out("out", false);
    std::vector<std::unique_ptr<InputPort<double>>> readers;
    for (int i = 0; i < 8; ++i) {
        readers.push_back(std::make_unique<InputPort<double>>("in"));
        out.createConnection(*readers.back(), ConnPolicy::data());
    }
    double sample = 1, got = 0;
    for (auto _ : state) {
        out.write(sample);
        for (auto& reader : readers)
            if (reader->read(got) != NewData) return state.SkipWithError("sample lost");
        benchmark::DoNotOptimize(got);
    }
}

void connectAndDisconnect(benchmark::State& state) {
    OutputPort<double> out("out");
    InputPort<double> in("in");
    for (auto _ : state) {
        out.createConnection(in, ConnPolicy::data());
        in.disconnect();
    }
}

constexpr auto doubles = roundTrip<double>;
constexpr auto structs = roundTrip<Bytes64>;
constexpr auto vectors = roundTrip<std::vector<double>>;
const ConnPolicy kData = ConnPolicy::data(ConnPolicy::LOCK_FREE);
const ConnPolicy kBuffer = ConnPolicy::buffer(10, ConnPolicy::LOCK_FREE);

}  // namespace

BENCHMARK_CAPTURE(doubles, data_lock_free, kData, false);
BENCHMARK_CAPTURE(doubles, data_lock_free_keep_last, kData, true);
BENCHMARK_CAPTURE(doubles, data_locked, ConnPolicy::data(ConnPolicy::LOCKED), false);
BENCHMARK_CAPTURE(doubles, data_unsync, ConnPolicy::data(ConnPolicy::UNSYNC), false);
BENCHMARK_CAPTURE(doubles, buffer_lock_free, kBuffer, false);
BENCHMARK_CAPTURE(doubles, buffer_lock_free_keep_last, kBuffer, true);
BENCHMARK_CAPTURE(doubles, buffer_locked, ConnPolicy::buffer(10, ConnPolicy::LOCKED), false);
BENCHMARK_CAPTURE(doubles, buffer_unsync, ConnPolicy::buffer(10, ConnPolicy::UNSYNC), false);
BENCHMARK_CAPTURE(structs, data_lock_free, kData, false);
BENCHMARK_CAPTURE(structs, buffer_lock_free, kBuffer, false);
BENCHMARK_CAPTURE(vectors, data_lock_free, kData, false);
BENCHMARK(oneToEight);
BENCHMARK(connectAndDisconnect);
