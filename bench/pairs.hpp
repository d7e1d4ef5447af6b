// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Measuring against a floor on a machine that also does other things: both in turn, in one run, judged by the ratio.
#ifndef OROFORGE_BENCH_PAIRS_HPP
#define OROFORGE_BENCH_PAIRS_HPP

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <vector>

namespace bench {

/** How many pairs a row takes; an odd number, so that the median is one of them. */
constexpr int kPairs = 31;

inline double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

inline double seconds(clockid_t clock) {
    timespec now;
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/** Seconds of `clock` that `work()` takes. */
template <class Work>
double timed(clockid_t clock, Work&& work) {
    const double begin = seconds(clock);
    work();
    return seconds(clock) - begin;
}

/** Each iteration of `state` is one pair of blocks: ours() and floor() measure one block each and return seconds per
    operation. Which one comes first changes from pair to pair. The time of the row is ours; bench/run compares the
    median `ratio` with `target`, the median `floor_ns` is for reading. Register with ->Iterations(kPairs)->UseManualTime(). */
template <class Ours, class Floor>
void inPairs(benchmark::State& state, double target, Ours&& ours, Floor&& floor) {
    std::vector<double> ratios, floors;
    ours(), floor();  // the first block of each pays for pages and caches
    bool oursFirst = true;
    for (auto _ : state) {
        double a = oursFirst ? ours() : 0;
        const double b = floor();
        if (!oursFirst) a = ours();
        oursFirst = !oursFirst;
        ratios.push_back(a / b);
        floors.push_back(b * 1e9);
        state.SetIterationTime(a);
    }
    state.counters["ratio"] = median(ratios);
    state.counters["target_ratio"] = target;
    state.counters["floor_ns"] = median(floors);
}

}  // namespace bench

#endif
