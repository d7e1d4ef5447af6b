// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Two components that call each other as fast as they can: no call is lost, nobody waits for ever.
#include "probe.hpp"

#include <rtt/internal/GlobalEngine.hpp>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

#ifndef OROFORGE_STRESS_CALLS
#define OROFORGE_STRESS_CALLS 500000
#endif
constexpr int kCalls = OROFORGE_STRESS_CALLS;  // in each direction

TEST(OperationStress, CallsInBothDirections) {
    Probe a("a"), b("b");
    long served[2] = {0, 0};  // each touched in its component's thread only
    a.addOperation(
        "next", [&](long n) { return ++served[0], n + 1; }, OwnThread);
    b.addOperation(
        "next", [&](long n) { return ++served[1], n + 1; }, OwnThread);
    OperationCaller<long(long)> toB(b.getOperation("next"), a.engine()), toA(a.getOperation("next"), b.engine());
    std::atomic<int> done{0};
    const auto work = [&](OperationCaller<long(long)>& other) {
        for (long i = 0; i != kCalls; ++i) ASSERT_EQ(other(i), i + 1);
        ++done;
    };
    a.onUpdate = [&] { work(toB); };
    b.onUpdate = [&] { work(toA); };
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(b.start());
    ASSERT_TRUE(eventually([&] { return done == 2; }, 3000));
    ASSERT_TRUE(a.stop());
    ASSERT_TRUE(b.stop());
    EXPECT_EQ(served[0], kCalls);
    EXPECT_EQ(served[1], kCalls);
}

TEST(OperationStress, SendsAndCollectsFromManyThreads) {
    Probe server("server");
    long sum = 0;  // touched in the server's thread only
    server.addOperation(
        "add", [&](int n) { return sum += n, n; }, OwnThread);
    std::vector<std::thread> clients;
    for (int c = 0; c != 3; ++c)
        clients.emplace_back([&] {
            OperationCaller<int(int)> add(server.getOperation("add"), internal::GlobalEngine::Instance());
            for (int i = 0; i != 1000; ++i) {
                SendHandle<int(int)> handles[8];
                for (auto& handle : handles) handle = add.send(1);
                for (auto& handle : handles) {
                    int got = 0;
                    ASSERT_EQ(handle.collect(got), SendSuccess);
                    ASSERT_EQ(got, 1);
                }
            }
        });
    for (std::thread& client : clients) client.join();
    OperationCaller<int(int)> last(server.getOperation("add"), internal::GlobalEngine::Instance());
    last(0);
    EXPECT_EQ(sum, 3 * 8 * 1000);
}

TEST(OperationStress, ComponentsThatFailWhileTheyAreCalledLeaveNobodyWaiting) {
    for (int round = 0; round != 100; ++round) {
        Probe server("server");
        server.addOperation(
            "op", [] { return 1; }, OwnThread);
        std::atomic<bool> started{false};
        std::thread client([&] {
            OperationCaller<int()> op(server.getOperation("op"), internal::GlobalEngine::Instance());
            try {
                for (;;) {
                    op();
                    started = true;
                }
            } catch (const SendError&) {
                started = true;
            }
        });
        ASSERT_TRUE(eventually([&] { return started.load(); }));
        server.fatal();
        client.join();
    }
}

TEST(OperationStress, StartAndStopWhileCalled) {
    Probe server("server");
    server.addOperation(
        "op", [](int n) { return n; }, OwnThread);
    std::atomic<bool> stop{false};
    std::thread client([&] {
        OperationCaller<int(int)> op(server.getOperation("op"), internal::GlobalEngine::Instance());
        for (int i = 0; !stop; ++i) ASSERT_EQ(op(i), i);
    });
    for (int i = 0; i != 300; ++i) {
        ASSERT_TRUE(server.start());
        ASSERT_TRUE(server.stop());
    }
    stop = true;
    client.join();
}

}  // namespace
