// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Deployment of a chain of components from XML: load, connect, configure, start, and taking all down again.
#include <ocl/DeploymentComponent.hpp>
#include <rtt/Component.hpp>
#include <rtt/Port.hpp>
#include <rtt/os/startstop.h>

#include <benchmark/benchmark.h>

#include <cstdio>
#include <fstream>
#include <malloc.h>
#include <string>

namespace deployment_bench {

class Link : public RTT::TaskContext {
public:
    explicit Link(const std::string& name) : RTT::TaskContext(name) {
        addPort("in", in_);
        addPort("out", out_);
        addProperty("gain", gain_);
    }

private:
    void updateHook() override {
        double value = 0;
        if (in_.read(value) == RTT::NewData) out_.write(value * gain_);
    }

    RTT::InputPort<double> in_;
    RTT::OutputPort<double> out_;
    double gain_ = 1;
};

}  // namespace deployment_bench

ORO_CREATE_COMPONENT(deployment_bench::Link)

namespace {

const char* const kFile = "deployment_bench.xml";

/** A file in which the output of each component feeds the next one. */
void writeChain(long count, const std::string& activity) {
    std::ofstream file(kFile);
    file << "<properties>\n";
    for (long i = 0; i < count; ++i) {
        file << "<struct name=\"link" << i << "\" type=\"deployment_bench::Link\">\n"
             << activity << "<simple name=\"AutoConf\" type=\"boolean\"><value>1</value></simple>\n"
             << "<simple name=\"AutoStart\" type=\"boolean\"><value>1</value></simple>\n"
             << "<struct name=\"Properties\" type=\"PropertyBag\"><simple name=\"gain\" "
                "type=\"double\"><value>1.5</value></simple></struct>\n"
             << "<struct name=\"Ports\" type=\"PropertyBag\">\n"
             << "<simple name=\"in\" type=\"string\"><value>wire" << i << "</value></simple>\n"
             << "<simple name=\"out\" type=\"string\"><value>wire" << i + 1 << "</value></simple>\n"
             << "</struct></struct>\n";
    }
    // The ends of the chain meet, so that no port is left over.
    file << "<struct name=\"end\" type=\"deployment_bench::Link\">" << activity
         << "<struct name=\"Ports\" type=\"PropertyBag\">\n"
         << "<simple name=\"in\" type=\"string\"><value>wire" << count << "</value></simple>\n"
         << "<simple name=\"out\" type=\"string\"><value>wire0</value></simple></struct></struct>\n"
         << "</properties>\n";
}

/** The targets are those of 1,000 components. */
void deployChain(benchmark::State& state, const std::string& activity, double targetMs) {
    writeChain(state.range(0), activity);
    OCL::DeploymentComponent deployer("Deployer", kFile + std::string(".none"));
    for (auto step : state) {
        (void)step;
        if (!deployer.kickStart(kFile)) state.SkipWithError("the file was not deployed");
        state.PauseTiming();
        deployer.kickOutAll();
        state.ResumeTiming();
    }
    std::remove(kFile);
    if (state.range(0) == 1000) state.counters["target_ms"] = targetMs;
}

const char* const kSequential = "<struct name=\"Activity\" type=\"SequentialActivity\"/>\n";

void sequential(benchmark::State& state) { deployChain(state, kSequential, 45); }

void ownThreads(benchmark::State& state) { deployChain(state, "", 100); }

BENCHMARK(sequential)->Name("deployment/sequential")->Arg(1)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(ownThreads)->Name("deployment/own_threads")->Arg(1)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

/** Bytes on the heap, with what malloc adds. */
double heapBytes() { return static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd); }

void memory(benchmark::State& state) {
    constexpr long kComponents = 1000;
    writeChain(kComponents, kSequential);
    OCL::DeploymentComponent deployer("Deployer", kFile + std::string(".none"));
    for (auto step : state) {
        (void)step;
        const double before = heapBytes();
        if (!deployer.kickStart(kFile)) state.SkipWithError("the file was not deployed");
        state.counters["bytes"] = (heapBytes() - before) / kComponents;
    }
    deployer.kickOutAll();
    std::remove(kFile);
    state.counters["target_bytes"] = 15e3;
}
BENCHMARK(memory)->Name("deployment/memory of a sequential component")->Iterations(1)->Unit(benchmark::kMillisecond);

/** Starts and stops the runtime around the benchmarks. */
struct Runtime {
    Runtime() {
        static char name[] = "deployment_bench";
        static char* words[] = {name, nullptr};
        __os_init(1, words);
    }
    ~Runtime() { __os_exit(); }
} runtime;

}  // namespace
