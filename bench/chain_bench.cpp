// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a chain of 100 empty members costs: beside a loop that calls their hooks, and beside one thread for each.
#include "pairs.hpp"

#include <ocl/Chain.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/startstop.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

namespace {

constexpr int kMembers = 100, kCycles = 2000;

/** The runtime, which says nothing. */
void prepare() {
    static const bool done = [] {
        setenv("ORO_LOGFILE", "/dev/null", 1);
        static char name[] = "chain_bench";
        static char* arguments[] = {name, nullptr};
        __os_init(1, arguments);
        RTT::Logger::Instance()->setLogLevel(RTT::Logger::Error);
        return true;
    }();
    (void)done;
}

class Empty : public RTT::TaskContext {
public:
    explicit Empty(const std::string& name) : RTT::TaskContext(name) {}
    ~Empty() override { stopForGood(); }
    void updateHook() override { ++updates; }
    long updates = 0;
};

struct Members {
    /** Slaves of the chain; null: each has a thread with the period 1 ms. */
    explicit Members(OCL::Chain* chain) {
        for (int i = 0; i < kMembers; ++i) {
            all.push_back(std::make_unique<Empty>("m" + std::to_string(i)));
            Empty& one = *all.back();
            if (chain)
                one.setActivity(new RTT::extras::SlaveActivity(chain->getActivity()));
            else
                one.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001, nullptr, one.getName()));
            if (chain) chain->addPeer(&one);
            one.start();
        }
    }
    std::vector<std::unique_ptr<Empty>> all;
};

/** Seconds per cycle. */
template <class Cycle>
double each(Cycle&& cycle) {
    return bench::timed(CLOCK_THREAD_CPUTIME_ID,
                        [&] {
                            for (int i = 0; i < kCycles; ++i) cycle();
                        }) /
           kCycles;
}

enum class Floor { Hooks, Updates };

void cycleOf100(benchmark::State& state, Floor floor) {
    prepare();
    OCL::Chain chain("chain");
    chain.setActivity(new RTT::extras::SlaveActivity(0.001));
    Members members(&chain);
    if (!chain.start()) return state.SkipWithError("the chain does not start");
    std::vector<double> more;
    const auto ours = [&] { return each([&] { chain.update(); }); };
    const auto theirs = [&] {
        return each([&] {
            for (const auto& member : members.all)
                floor == Floor::Hooks ? member->updateHook() : static_cast<void>(member->update());
        });
    };
    ours(), theirs();
    for (auto _ : state) {
        const double a = ours(), b = theirs();
        more.push_back((a - b) * 1e6);
        state.SetIterationTime(a);
    }
    state.counters["more_us"] = bench::median(more);
    chain.stop();
}
void besideHooks(benchmark::State& state) { cycleOf100(state, Floor::Hooks); }
void besideUpdates(benchmark::State& state) { cycleOf100(state, Floor::Updates); }
BENCHMARK(besideHooks)->Name("chain/100 members, beside a loop of hooks")->Iterations(bench::kPairs)->UseManualTime();
BENCHMARK(besideUpdates)
    ->Name("chain/100 members, beside a loop of update()")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

/** CPU seconds of this process per second. */
double load() {
    return bench::timed(CLOCK_PROCESS_CPUTIME_ID, [] { std::this_thread::sleep_for(std::chrono::seconds(1)); });
}

void besideThreads(benchmark::State& state) {
    prepare();
    for (auto _ : state) {
        double chained = 0, threads = 0;
        {
            OCL::Chain chain("chain");
            chain.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001, nullptr, "chain"));
            Members members(&chain);
            if (!chain.start()) return state.SkipWithError("the chain does not start");
            chained = load();
            chain.stop();
        }
        {
            Members members(nullptr);
            threads = load();
        }
        state.SetIterationTime(chained);
        state.counters["cpu_chain"] = chained;
        state.counters["cpu_threads"] = threads;
    }
}
BENCHMARK(besideThreads)->Name("chain/1 kHz, beside 100 threads")->Iterations(1)->UseManualTime();

}  // namespace
