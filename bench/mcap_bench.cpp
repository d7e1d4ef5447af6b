// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// McapReporting: what a message costs the reporter's thread, large samples, and 200 ports at 1 kHz. The player: what
// a message costs, from opening the file to a connected port.
#include <ocl/McapReporting.hpp>
#include <replay/player.hpp>
#include <reporting/mcap/crc32.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/InputPort.hpp>
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

/** From the first write to the complete file, samples of 1 MB as fast as they are written: an uncompressed file is at
    most 8 MB behind. `per_cpu` is for a second of processor time of all threads, whatever else the machine does. */
void LargeSamples(benchmark::State& state) {
    constexpr std::uintmax_t kSamples = 400, kBytes = 1000000, kBehind = 8;
    const std::vector<double> sample(kBytes / sizeof(double), 0.1);
    const bool isPlain = state.range(0) == 0;
    std::int64_t samples = 0;
    const std::clock_t used = std::clock();
    for (auto _ : state) {
        Setup<std::vector<double>> setup(1, kCompressions[state.range(0)], 4U << 20, 8);
        setup.recorder.setActivity(new RTT::extras::SlaveActivity(0.001));
        if (!setup.recorder.start()) std::abort();
        for (std::uintmax_t i = 0; i < kSamples; ++i) {
            while (isPlain && i > kBehind && std::filesystem::file_size(fileName()) < (i - kBehind) * kBytes)
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            setup.write(sample);
            setup.recorder.update();
        }
        setup.recorder.stop();
        state.counters["lost"] = setup.lost();
        samples += static_cast<std::int64_t>(kSamples) - static_cast<std::int64_t>(setup.lost());
    }
    const auto bytes = static_cast<double>(samples) * kBytes;
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
    state.counters["per_cpu"] = benchmark::Counter(bytes * CLOCKS_PER_SEC / static_cast<double>(std::clock() - used),
                                                   benchmark::Counter::kDefaults, benchmark::Counter::kIs1024);
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

/** Makes a recording of that many samples of each port, and replays it as fast as possible, into ports that are read. */
template <class T>
void replay(benchmark::State& state, long ports, int samples, const T& sample) {
    Setup<T> setup(ports, kCompressions[state.range(0)], 1U << 20);
    setup.recorder.setActivity(new RTT::extras::SlaveActivity(0.001));
    setup.template set<std::string>("Clock", "component");
    setup.set("Reproducible", true);  // it waits for the file
    if (!setup.recorder.start()) std::abort();
    for (int i = 0; i < samples; ++i) {
        setup.write(sample);
        if (i % 100 == 99) setup.recorder.update();
    }
    setup.recorder.stop();
    const auto bytes = static_cast<double>(std::filesystem::file_size(fileName()));
    std::uint64_t written = 0;
    for (auto _ : state) {
        std::string problem;
        const std::unique_ptr<OCL::replay::Player> player(oroOpenRecording(fileName().c_str(), {}, problem));
        if (!player) std::abort();
        std::vector<std::unique_ptr<RTT::InputPort<T>>> readers;
        for (const OCL::replay::Topic& topic : player->topics()) {
            readers.push_back(std::make_unique<RTT::InputPort<T>>("in"));
            if (!player->port(topic.topic, problem)->connectTo(readers.back().get())) std::abort();
        }
        while (player->next()) player->deliver();
        written += player->written();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(written));
    state.counters["lost"] = setup.lost();
    state.counters["bytes"] = bytes;
}
void ReplayNumbers(benchmark::State& state) { replay(state, 200, 5000, 0.1); }
BENCHMARK(ReplayNumbers)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();
void ReplayLargeSamples(benchmark::State& state) { replay(state, 1, 400, std::vector<double>(125000, 0.1)); }
BENCHMARK(ReplayLargeSamples)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->UseRealTime();

void Checksum(benchmark::State& state) {
    const std::vector<unsigned char> bytes(1 << 20, 7);
    for (auto _ : state) benchmark::DoNotOptimize(oroforge::mcap::crc32(bytes.data(), bytes.size()));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(Checksum);

}  // namespace
