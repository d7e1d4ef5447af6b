// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calling operations: in the caller's thread, in another one, many at once; and a step of an engine with nothing to do.
#include <rtt/Activity.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>

#include <benchmark/benchmark.h>

#include <atomic>
#include <climits>
#include <cstdint>
#include <linux/futex.h>
#include <memory>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace RTT;

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

/** A component with a thread of its own, to call from. Its work is done in an operation of its own. */
template <class Work>
void inComponent(TaskContext& component, Work work) {
    std::atomic<bool> done{false};
    component.addOperation(
        "work",
        [&] {
            work();
            done = true;
        },
        OwnThread);
    OperationCaller<void()>(component.getOperation("work")).send();
    while (!done) usleep(1000);
    component.provides()->removeOperation("work");
}

void directCall(benchmark::State& state) {
    Server server("server");
    OperationCaller<int(int)> plus(server.getOperation("client"), server.engine());
    for (auto _ : state) benchmark::DoNotOptimize(plus(1));
}
BENCHMARK(directCall)->Name("operation/ClientThread call");

void callBetweenThreads(benchmark::State& state) {
    Server server("server"), client("client");
    OperationCaller<int(int)> plus(server.getOperation("own"), client.engine());
    inComponent(client, [&] {
        for (auto _ : state) benchmark::DoNotOptimize(plus(1));
    });
}
BENCHMARK(callBetweenThreads)->Name("operation/OwnThread call")->UseRealTime();

void sendAndCollect(benchmark::State& state) {
    Server server("server"), client("client");
    OperationCaller<int(int)> plus(server.getOperation("own"), client.engine());
    inComponent(client, [&] {
        SendHandle<int(int)> handles[16];
        for (auto _ : state) {
            for (auto& handle : handles) handle = plus.send(1);
            for (auto& handle : handles) {
                int result = 0;
                handle.collect(result);
                benchmark::DoNotOptimize(result);
            }
        }
        state.SetItemsProcessed(state.iterations() * 16);
    });
}
BENCHMARK(sendAndCollect)->Name("operation/16 sends, 16 collects")->UseRealTime();

/** The floor of a call between threads: two threads that wake each other by nothing but a futex. */
void futexPingPong(benchmark::State& state) {
    std::atomic<std::uint32_t> turn{0};
    const auto wait = [&](std::uint32_t while_) {
        while (turn.load(std::memory_order_acquire) == while_)
            syscall(SYS_futex, &turn, FUTEX_WAIT_PRIVATE, while_, nullptr, nullptr, 0);
    };
    const auto pass = [&](std::uint32_t to) {
        turn.store(to, std::memory_order_release);
        syscall(SYS_futex, &turn, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
    };
    std::thread other([&] {
        for (;;) {
            wait(0);
            if (turn == 2) return;
            pass(0);
        }
    });
    for (auto _ : state) {
        pass(1);
        wait(1);
    }
    pass(2);
    other.join();
}
BENCHMARK(futexPingPong)->Name("operation/floor: futex ping-pong")->UseRealTime();

void emptyStep(benchmark::State& state) {
    Server server("server");
    server.setActivity(new extras::SlaveActivity());
    server.start();
    for (auto _ : state) server.update();
}
BENCHMARK(emptyStep)->Name("engine/step with updateHook");

}  // namespace
