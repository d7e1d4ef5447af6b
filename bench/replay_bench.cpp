// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How many times faster than real time 50 components are executed in simulated time: half of them have a period of 1 ms,
// the others are woken by messages, one for each in a millisecond. `times` is the factor; the goal is 20.
#include <replay/player.hpp>
#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/startstop.h>
#include <schedule/schedule.hpp>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr int kPairs = 25;
constexpr RTT::nsecs kMillisecond = 1000000, kStart = 1700000000000000000;

/** The runtime, which says nothing. */
void prepare() {
    static const bool done = [] {
        setenv("ORO_LOGFILE", "/dev/null", 1);
        static char name[] = "replay_bench";
        static char* arguments[] = {name, nullptr};
        __os_init(1, arguments);
        RTT::Logger::Instance()->setLogLevel(RTT::Logger::Error);
        return true;
    }();
    (void)done;
}

/** Sends twice what it gets. */
class Doubling : public RTT::TaskContext {
public:
    Doubling(const std::string& name, double period) : RTT::TaskContext(name) {
        if (period > 0) {
            addPort("in", in);
            setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, period, nullptr, name));
        } else {
            addEventPort("in", in);
        }
        addPort("out", out);
    }
    ~Doubling() override { stopForGood(); }
    void updateHook() override {
        double value = 0;
        if (in.read(value) == RTT::NewData) out.write(2 * value);
    }
    RTT::InputPort<double> in;
    RTT::OutputPort<double> out;
};

/** A message for each port in each millisecond. */
class Messages : public OCL::replay::TimedSource {
public:
    Messages(std::vector<std::unique_ptr<RTT::OutputPort<double>>>& ports, long ms) : ports_(ports), left_(ms) {}
    std::optional<RTT::nsecs> next() override {
        if (left_ == 0) return std::nullopt;
        return time_;
    }
    void deliver() override {
        for (const auto& port : ports_) port->write(1.0);
        time_ += kMillisecond;
        --left_;
    }

private:
    std::vector<std::unique_ptr<RTT::OutputPort<double>>>& ports_;
    RTT::nsecs time_ = kStart + kMillisecond;
    long left_;
};

void fiftyComponents(benchmark::State& state) {
    prepare();
    constexpr long kSimulated = 2000;  // ms
    for (auto _ : state) {
        state.PauseTiming();
        OCL::schedule::Schedule schedule(kStart);
        std::vector<std::unique_ptr<RTT::OutputPort<double>>> ports;
        std::vector<std::unique_ptr<Doubling>> components;
        for (int i = 0; i != kPairs; ++i) {
            ports.push_back(std::make_unique<RTT::OutputPort<double>>("port"));
            components.push_back(std::make_unique<Doubling>("woken" + std::to_string(i), 0));
            ports.back()->connectTo(&components.back()->in);
            components.push_back(std::make_unique<Doubling>("periodic" + std::to_string(i), 0.001));
            components[components.size() - 2]->out.connectTo(&components.back()->in);
        }
        for (const auto& component : components) component->start();
        Messages messages(ports, kSimulated);
        state.ResumeTiming();
        const auto outcome = schedule.run(messages, [] { return false; });
        benchmark::DoNotOptimize(outcome.executions);
        state.PauseTiming();
        components.clear();
        state.ResumeTiming();
    }
    state.counters["times"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * kSimulated / 1000, benchmark::Counter::kIsRate);
}
BENCHMARK(fiftyComponents)->Unit(benchmark::kMillisecond);

}  // namespace
