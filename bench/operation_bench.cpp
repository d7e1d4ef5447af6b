// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calling operations: in the caller's thread, in another one, many at once; and a step of an engine with nothing to do.
#include "futex_floor.hpp"
#include "pairs.hpp"

#include <rtt/Activity.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <benchmark/benchmark.h>

#include <ctime>
#include <functional>
#include <string>
#include <thread>

namespace {

using namespace RTT;
using bench::kRoundTrips;
using bench::Placement;

class Server : public TaskContext {
public:
    explicit Server(const std::string& name) : TaskContext(name) {
        addOperation("client", &Server::plus, this, ClientThread);
        addOperation("own", &Server::plus, this, OwnThread);
    }
    ~Server() override { stop(); }
    int plus(int x) { return sum_ += x; }

private:
    int sum_ = 0;
};

/** A component with a thread of its own, to call from. */
class Client : public TaskContext {
public:
    explicit Client(unsigned cpu) : TaskContext("client") {
        addOperation(
            "work", [this] { work_(); }, OwnThread);
        run_ = OperationCaller<void()>(getOperation("work"), internal::GlobalEngine::Instance());
        if (cpu != 0) getActivity()->setCpuAffinity(cpu);
    }
    ~Client() override { stop(); }
    /** Seconds that `work()` takes in the thread of this component, for each of `operations`. */
    template <class Work>
    double timed(int operations, Work work) {
        double elapsed = 0;
        work_ = [&] { elapsed = bench::timed(CLOCK_MONOTONIC, work); };
        run_();
        return elapsed / operations;
    }

private:
    std::function<void()> work_;
    OperationCaller<void()> run_;
};

void directCall(benchmark::State& state) {
    Server server("server");
    OperationCaller<int(int)> plus(server.getOperation("client"), server.engine());
    for (auto _ : state) benchmark::DoNotOptimize(plus(1));
    state.counters["target_ns"] = 3.5;
}
BENCHMARK(directCall)->Name("operation/ClientThread call");

/** A server and a client that call from one thread to another. */
struct Between {
    explicit Between(Placement where) : server("server"), client(where.second) {
        if (where.first != 0) server.getActivity()->setCpuAffinity(where.first);
        plus = OperationCaller<int(int)>(server.getOperation("own"), client.engine());
    }
    double call() {
        return client.timed(kRoundTrips, [&] {
            for (int i = 0; i != kRoundTrips; ++i) benchmark::DoNotOptimize(plus(1));
        });
    }
    double sendAndCollect() {
        return client.timed(kRoundTrips, [&] {
            SendHandle<int(int)> handles[16];
            for (int i = 0; i != kRoundTrips / 16; ++i) {
                for (auto& handle : handles) handle = plus.send(1);
                for (auto& handle : handles) {
                    int result = 0;
                    handle.collect(result);
                    benchmark::DoNotOptimize(result);
                }
            }
        });
    }
    Server server;
    Client client;
    OperationCaller<int(int)> plus;
};

void callBetweenThreads(benchmark::State& state, Placement where) {
    if (where.second > 1 && std::thread::hardware_concurrency() < 2) return state.SkipWithError("needs two CPUs");
    Between threads(where);
    bench::inPairs(
        state, 1.25, [&] { return threads.call(); }, [&] { return bench::futexPingPong(where); });
}
BENCHMARK_CAPTURE(callBetweenThreads, free, Placement{0, 0})
    ->Name("operation/OwnThread call against futex ping-pong")
    ->Iterations(bench::kPairs)
    ->UseManualTime();
BENCHMARK_CAPTURE(callBetweenThreads, apart, Placement{1, 2})
    ->Name("operation/the same, each on its own CPU")
    ->Iterations(bench::kPairs)
    ->UseManualTime();
BENCHMARK_CAPTURE(callBetweenThreads, together, Placement{1, 1})
    ->Name("operation/the same, both on one CPU")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

void sendAndCollect(benchmark::State& state) {
    Between threads(Placement{0, 0});
    bench::inPairs(
        state, 0.25, [&] { return threads.sendAndCollect(); }, [&] { return threads.call(); });
}
BENCHMARK(sendAndCollect)
    ->Name("operation/16 sends, 16 collects against 16 calls")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

void emptyStep(benchmark::State& state) {
    Server server("server");
    server.setActivity(new extras::SlaveActivity());
    server.start();
    for (auto _ : state) server.update();
    state.counters["target_ns"] = 12;
}
BENCHMARK(emptyStep)->Name("engine/step with updateHook");

}  // namespace
