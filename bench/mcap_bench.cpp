// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// McapReporting: what a message costs the reporter's thread, large samples, and 200 ports at 1 kHz.
#include <ocl/McapReporting.hpp>
#include <reporting/mcap/crc32.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/startstop.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <dlfcn.h>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

const char* const kCompressions[] = {"none", "lz4", "zstd"};

void startRuntime() {
    static const bool once = [] {
        RTT::Logger::Instance()->setLogLevel(RTT::Never);
        static char name[] = "mcap_bench";
        static char* words[] = {name, nullptr};
        void* const library = dlopen(RTT_TYPEKIT_FILE, RTLD_NOW);
        if (__os_init(1, words) != 0 || !library) std::abort();
        return reinterpret_cast<bool (*)(void*)>(dlsym(library, "loadRTTPlugin"))(nullptr);
    }();
    if (!once) std::abort();
}

/** /dev/shm, so that no disk is measured; OROFORGE_BENCH_FOLDER is another one. */
std::string fileName() {
    const char* const given = std::getenv("OROFORGE_BENCH_FOLDER");
    return std::string(given ? given : "/dev/shm") + "/mcap_bench.mcap";
}

template <class T>
class Setup {
public:
    Setup(long ports, const char* compression, unsigned chunk, int buffer = 200) {
        startRuntime();
        for (long i = 0; i < ports; ++i) {
            ports_.push_back(std::make_unique<RTT::OutputPort<T>>("port" + std::to_string(i)));
            component_.addPort(*ports_.back());
        }
        recorder.addPeer(&component_);
        set<std::string>("ReportFile", fileName());
        set<std::string>("Compression", compression);
        set("ChunkSize", chunk);
        RTT::ConnPolicy policy = RTT::ConnPolicy::circularBuffer(buffer);
        set("ReportPolicy", policy);
        if (!recorder.reportComponent("component")) std::abort();
    }
    ~Setup() { std::remove(fileName().c_str()); }

    template <class V>
    void set(const char* name, const V& value) {
        dynamic_cast<RTT::Property<V>&>(*recorder.getProperty(name)).set(value);
    }
    void write(const T& value) {
        for (const auto& port : ports_) port->write(value);
    }
    unsigned lost() { return RTT::Attribute<unsigned>(recorder.getAttribute("LostRows")).get(); }

private:
    RTT::TaskContext component_{"component"};
    std::vector<std::unique_ptr<RTT::OutputPort<T>>> ports_;

public:
    OCL::McapReporting recorder{"recorder"};
};

/** 100 samples of each of 200 ports are taken from their buffers and encoded. */
void Message(benchmark::State& state) {
    constexpr int kPorts = 200, kSamples = 100;
    Setup<double> setup(kPorts, kCompressions[state.range(0)], 1U << 20);
    setup.recorder.setActivity(new RTT::extras::SlaveActivity(0.001));
    if (!setup.recorder.start()) std::abort();
    for (auto _ : state) {
        state.PauseTiming();
        for (int i = 0; i < kSamples; ++i) setup.write(i * 0.1);
        state.ResumeTiming();
        setup.recorder.update();
    }
    setup.recorder.stop();
    state.SetItemsProcessed(state.iterations() * kPorts * kSamples);
    state.counters["lost"] = setup.lost();
}
BENCHMARK(Message)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();

/** From the first write to the complete file, samples of 1 MB as fast as they can be made; counts those in the file. */
void LargeSamples(benchmark::State& state) {
    constexpr int kSamples = 400;
    const std::vector<double> sample(125000, 0.1);
    std::int64_t samples = 0;
    for (auto _ : state) {
        Setup<std::vector<double>> setup(1, kCompressions[state.range(0)], 8U << 20, 8);
        setup.recorder.setActivity(new RTT::extras::SlaveActivity(0.001));
        if (!setup.recorder.start()) std::abort();
        for (int i = 0; i < kSamples; ++i) {
            setup.write(sample);
            setup.recorder.update();
        }
        setup.recorder.stop();
        state.counters["lost"] = setup.lost();
        samples += kSamples - static_cast<std::int64_t>(setup.lost());
    }
    state.SetBytesProcessed(samples * 1000000);
}
BENCHMARK(LargeSamples)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();

/** 200 ports at 1 kHz for OROFORGE_BENCH_SECONDS (2) seconds; `cpu` is the part of one processor, writers included. */
void AtOneKilohertz(benchmark::State& state) {
    const char* const given = std::getenv("OROFORGE_BENCH_SECONDS");
    const int seconds = given ? std::atoi(given) : 2;
    for (auto _ : state) {
        Setup<double> setup(200, "zstd", 1U << 20);
        setup.recorder.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.01));
        if (!setup.recorder.start()) std::abort();
        const auto begin = std::chrono::steady_clock::now();
        const std::clock_t used = std::clock();
        for (int i = 0; i < seconds * 1000; ++i) {
            setup.write(i * 0.123456);
            std::this_thread::sleep_until(begin + std::chrono::milliseconds(i + 1));
        }
        setup.recorder.stop();
        const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        state.counters["cpu"] = static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / all;
        state.counters["lost"] = setup.lost();
        state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(fileName()));
    }
}
BENCHMARK(AtOneKilohertz)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

void Checksum(benchmark::State& state) {
    const std::vector<unsigned char> bytes(1 << 20, 7);
    for (auto _ : state) benchmark::DoNotOptimize(oroforge::mcap::crc32(bytes.data(), bytes.size()));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(Checksum);

}  // namespace
