// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Encoding and decoding, against copying the same bytes.
#include "pairs.hpp"

#include <rtt/encoding/Plan.hpp>
#include <rtt/types/GeneratedTypekit.hpp>
#include <rtt/types/Types.hpp>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <dlfcn.h>

namespace measured {

struct Plain {
    double values[8];
};
struct Sample {
    std::string name = "joints";
    double x = 1, y = 2, z = 3;
    std::vector<double> values = std::vector<double>(1000, 0.5);
};
struct Point {
    double x = 1, y = 2, z = 3;
};

}  // namespace measured

namespace {

namespace t = RTT::types;
using namespace RTT::encoding;
using measured::Plain;
using measured::Point;
using measured::Sample;

constexpr t::Member plainMembers[] = {{"values", 0, &t::typeRef<double>, 8, "", ""}};
constexpr t::Member sampleMembers[] = {
    {"name", offsetof(Sample, name), &t::typeRef<std::string>, 0, "", ""},
    {"x", offsetof(Sample, x), &t::typeRef<double>, 0, "", ""},
    {"y", offsetof(Sample, y), &t::typeRef<double>, 0, "", ""},
    {"z", offsetof(Sample, z), &t::typeRef<double>, 0, "", ""},
    {"values", offsetof(Sample, values), &t::typeRef<std::vector<double>>, 0, "", ""},
};
constexpr t::Member pointMembers[] = {
    {"x", offsetof(Point, x), &t::typeRef<double>, 0, "", ""},
    {"y", offsetof(Point, y), &t::typeRef<double>, 0, "", ""},
    {"z", offsetof(Point, z), &t::typeRef<double>, 0, "", ""},
};

void addTypes() {
    static const bool added = [] {
        void* const library = dlopen(RTT_TYPEKIT_FILE, RTLD_NOW);
        reinterpret_cast<bool (*)(RTT::TaskContext*)>(dlsym(library, "loadRTTPlugin"))(nullptr);
        const auto types = t::Types();
        types->addType(t::makeStructType<Plain>("/measured/Plain", plainMembers, 1));
        types->addType(t::makeStructType<Sample>("/measured/Sample", sampleMembers, 5));
        types->addType(t::makeStructType<Point>("/measured/Point", pointMembers, 3));
        types->addType(t::makeSequenceType<std::vector<Point>>("/measured/Points"));
        return true;
    }();
    (void)added;
}

/** A value, its plan and a buffer. */
template <class T>
struct Coded {
    Coded() {
        addTypes();
        std::string why;
        plan = Plan::make(*t::Types()->getTypeInfo<T>(), cdrRules(), why);
    }
    void thereAndBack() {
        const std::size_t size = plan->encode(&value, bytes.data(), bytes.size());
        benchmark::DoNotOptimize(plan->decode(bytes.data(), size, kNativeOrder, &back));
        benchmark::ClobberMemory();
    }
    /** Copies `size` bytes into the buffer and back. */
    void twoCopies(const void* from, void* to, std::size_t size) {
        std::memcpy(bytes.data(), from, size);
        benchmark::ClobberMemory();
        std::memcpy(to, bytes.data(), size);
        benchmark::ClobberMemory();
    }
    std::shared_ptr<const Plan> plan;
    T value{}, back{};
    std::vector<char> bytes = std::vector<char>(100000);
};

void plain(benchmark::State& state) {
    Coded<Plain> coded;
    for (auto _ : state) coded.thereAndBack();
    state.counters["target_ns"] = 25;
}
BENCHMARK(plain)->Name("encoding/struct of 64 plain bytes, out and in");

template <class Ours, class Floor>
void against(benchmark::State& state, double target, Ours ours, Floor floor) {
    constexpr int kRounds = 2000;
    const auto each = [](auto& work) {
        return bench::timed(CLOCK_MONOTONIC,
                            [&] {
                                for (int i = 0; i != kRounds; ++i) work();
                            }) /
               kRounds;
    };
    bench::inPairs(
        state, target, [&] { return each(ours); }, [&] { return each(floor); });
}

void sample(benchmark::State& state) {
    Coded<Sample> coded;
    against(
        state, 1.3, [&] { coded.thereAndBack(); },
        [&] { coded.twoCopies(coded.value.values.data(), coded.back.values.data(), 1000 * sizeof(double)); });
}
BENCHMARK(sample)
    ->Name("encoding/text, 3 numbers, 1,000 numbers against two copies")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

void points(benchmark::State& state) {
    Coded<std::vector<Point>> coded;
    coded.value.resize(1000);
    coded.back.resize(1000);
    against(
        state, 1.2, [&] { coded.thereAndBack(); },
        [&] { coded.twoCopies(coded.value.data(), coded.back.data(), 1000 * sizeof(Point)); });
}
BENCHMARK(points)
    ->Name("encoding/1,000 structs of numbers against two copies")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

}  // namespace
