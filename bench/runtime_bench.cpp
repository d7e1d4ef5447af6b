// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Memory of a process that does nothing but start the runtime, and what real-time memory costs beside the heap.
#include "pairs.hpp"

#include <rtt/os/oro_malloc.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

void runtimeMemory(benchmark::State& state) {
    setenv("ORO_LOGFILE", "/dev/null", 1);
    std::vector<double> linked, started;
    for (auto _ : state) {
        long before = 0, after = 0;
        std::FILE* const output = popen(RUNTIME_PROBE, "r");
        const bool read = output && std::fscanf(output, "%ld %ld", &before, &after) == 2;
        if (!output || pclose(output) != 0 || !read) return state.SkipWithError("the process did not measure");
        linked.push_back(static_cast<double>(before));
        started.push_back(static_cast<double>(after));
    }
    state.counters["bytes"] = bench::median(started);
    state.counters["before_init"] = bench::median(linked);
    state.counters["target_bytes"] = 12e6;
}
BENCHMARK(runtimeMemory)->Name("runtime/memory of a process")->Iterations(5)->Unit(benchmark::kMillisecond);

/** Some blocks of several sizes are held, so that neither allocator finds the same one each time. */
template <class Allocate, class Release>
void allocation(benchmark::State& state, Allocate allocate, Release release) {
    constexpr std::size_t kHeld = 64;
    void* held[kHeld] = {};
    std::size_t at = 0, size = 16;
    for (auto _ : state) {
        release(held[at]);
        held[at] = allocate(size);
        benchmark::DoNotOptimize(held[at]);
        at = (at + 17) % kHeld;
        size = 16 + (size * 7 + 13) % 500;
    }
    for (void* block : held) release(block);
}
void realTimeMemory(benchmark::State& state) { allocation(state, &oro_rt_malloc, &oro_rt_free); }
void heap(benchmark::State& state) { allocation(state, &std::malloc, &std::free); }
BENCHMARK(realTimeMemory)->Name("memory/oro_rt_malloc and oro_rt_free");
BENCHMARK(heap)->Name("memory/floor: malloc and free");

}  // namespace
