// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What it costs to bring a sample from an output port to an input port, in one thread.
#include "pairs.hpp"

#include <rtt/Port.hpp>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

using namespace RTT;

namespace {

struct Bytes64 {
    double numbers[8];
};

template <class T>
void writeAndRead(benchmark::State& state, const ConnPolicy& policy, bool keepLast, double target) {
    OutputPort<T> out("out", keepLast);
    InputPort<T> in("in");
    T sample = T(), got = T();
    if (!out.createConnection(in, policy)) return state.SkipWithError("not connected");
    for (auto _ : state) {
        benchmark::DoNotOptimize(sample);
        if (out.write(sample) != WriteSuccess || in.read(got) != NewData) return state.SkipWithError("sample lost");
        benchmark::DoNotOptimize(got);
    }
    if (target > 0) state.counters["target_ns"] = target;
}

/** The copy into the connection and the one out of it cannot be avoided. */
void vectorAgainstCopies(benchmark::State& state, const ConnPolicy& policy) {
    constexpr int kBlock = 2000;
    OutputPort<std::vector<double>> out("out", false);
    InputPort<std::vector<double>> in("in");
    std::vector<double> sample(1000, 1.0), got = sample, between = sample;
    out.setDataSample(sample);
    if (!out.createConnection(in, policy)) return state.SkipWithError("not connected");
    const auto ours = [&] {
        return bench::timed(CLOCK_THREAD_CPUTIME_ID,
                            [&] {
                                for (int i = 0; i < kBlock; ++i) {
                                    benchmark::DoNotOptimize(sample.data());
                                    if (out.write(sample) != WriteSuccess || in.read(got) != NewData)
                                        state.SkipWithError("sample lost");
                                    benchmark::ClobberMemory();
                                }
                            }) /
               kBlock;
    };
    const auto floor = [&] {
        const std::size_t bytes = sample.size() * sizeof(double);
        return bench::timed(CLOCK_THREAD_CPUTIME_ID,
                            [&] {
                                for (int i = 0; i < kBlock; ++i) {
                                    benchmark::DoNotOptimize(sample.data());
                                    std::memcpy(between.data(), sample.data(), bytes);
                                    benchmark::ClobberMemory();
                                    std::memcpy(got.data(), between.data(), bytes);
                                    benchmark::ClobberMemory();
                                }
                            }) /
               kBlock;
    };
    bench::inPairs(state, 1.5, ours, floor);
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
        benchmark::DoNotOptimize(sample);
        out.write(sample);
        for (auto& reader : readers)
            if (reader->read(got) != NewData) return state.SkipWithError("sample lost");
        benchmark::DoNotOptimize(got);
    }
    state.counters["target_ns"] = 80;
}

template <class T>
void row(const std::string& name, const ConnPolicy& policy, bool keepLast, double target) {
    benchmark::RegisterBenchmark(("port/" + name).c_str(),
                                 [=](benchmark::State& state) { writeAndRead<T>(state, policy, keepLast, target); })
        ->MinTime(0.05)
        ->Repetitions(9)
        ->ReportAggregatesOnly();
}

/** A target of 0 is none. */
const bool registered = [] {
    const auto data = [](int lock) { return ConnPolicy::data(lock); };
    const auto buffer = [](int lock) { return ConnPolicy::buffer(10, lock); };
    row<double>("double, DATA lock-free", data(ConnPolicy::LOCK_FREE), false, 12);
    row<double>("double, DATA lock-free, keep last", data(ConnPolicy::LOCK_FREE), true, 20);
    row<double>("double, DATA locked", data(ConnPolicy::LOCKED), false, 26);
    row<double>("double, DATA unsync", data(ConnPolicy::UNSYNC), false, 10);
    row<double>("double, BUFFER lock-free", buffer(ConnPolicy::LOCK_FREE), false, 14);
    row<double>("double, BUFFER lock-free, keep last", buffer(ConnPolicy::LOCK_FREE), true, 0);
    row<double>("double, BUFFER locked", buffer(ConnPolicy::LOCKED), false, 28);
    row<double>("double, BUFFER unsync", buffer(ConnPolicy::UNSYNC), false, 12);
    row<double>("double, CIRCULAR_BUFFER lock-free", ConnPolicy::circularBuffer(10), false, 0);
    row<Bytes64>("64-byte struct, DATA lock-free", data(ConnPolicy::LOCK_FREE), false, 18);
    row<Bytes64>("64-byte struct, BUFFER lock-free", buffer(ConnPolicy::LOCK_FREE), false, 40);
    row<std::string>("short string, DATA lock-free", data(ConnPolicy::LOCK_FREE), false, 0);
    row<std::string>("short string, BUFFER lock-free", buffer(ConnPolicy::LOCK_FREE), false, 0);
    benchmark::RegisterBenchmark("port/double, one writer, eight readers", oneToEight)
        ->MinTime(0.05)
        ->Repetitions(9)
        ->ReportAggregatesOnly();
    for (const bool buffered : {false, true})
        benchmark::RegisterBenchmark(buffered ? "port/vector<double>(1000), BUFFER against two memcpy"
                                              : "port/vector<double>(1000), DATA against two memcpy",
                                     [=](benchmark::State& state) {
                                         vectorAgainstCopies(state,
                                                             buffered ? ConnPolicy::buffer(10) : ConnPolicy::data());
                                     })
            ->Iterations(bench::kPairs)
            ->UseManualTime();
    return true;
}();

}  // namespace
