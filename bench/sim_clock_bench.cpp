// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A step of simulated time: the caller moves the manual clock and waits until the components have executed.
#include <rtt_rosclock/rtt_rosclock.h>

#include <rtt/TaskContext.hpp>

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

namespace {

void stepOfComponents(benchmark::State& state) {
    std::vector<std::unique_ptr<RTT::TaskContext>> components;
    for (int i = 0; i != state.range(0); ++i) {
        components.push_back(std::make_unique<RTT::TaskContext>("c" + std::to_string(i)));
        components.back()->setPeriod(0.01);
        rtt_rosclock::set_sim_clock_activity(components.back().get());
        components.back()->start();
    }
    rtt_rosclock::enable_sim();
    uint64_t now = 0;
    for (auto _ : state) rtt_rosclock::update_sim_clock(ros::Time().fromNSec(now += 10000000));
    rtt_rosclock::disable_sim();
    for (const auto& component : components) component->stop();
}
BENCHMARK(stepOfComponents)->Name("sim clock/step of components")->Arg(0)->Arg(1)->Arg(100)->UseRealTime();

}  // namespace
