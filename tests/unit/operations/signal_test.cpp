// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "probe.hpp"

#include <rtt/internal/Signal.hpp>

using namespace RTT;
using oroforge::test::Probe;

namespace {

typedef internal::Signal<void(int)> IntSignal;

TEST(Signal, CallsInOrderOfConnection) {
    IntSignal signal;
    std::string order;
    signal.emit(0);
    Handle a = signal.connect([&](int n) { order += "a" + std::to_string(n); });
    Handle b = signal.connect([&](int n) { order += "b" + std::to_string(n); });
    signal.emit(1);
    signal(2);
    EXPECT_EQ(order, "a1b1a2b2");
}

TEST(Signal, HandleConnectsAndDisconnects) {
    IntSignal signal;
    int calls = 0;
    Handle handle = signal.setup([&](int) { ++calls; });
    EXPECT_TRUE(handle.ready());
    EXPECT_FALSE(handle.connected());
    signal.emit(1);
    EXPECT_EQ(calls, 0);
    EXPECT_TRUE(handle.connect());
    EXPECT_FALSE(handle.connect());
    signal.emit(1);
    EXPECT_EQ(calls, 1);
    EXPECT_TRUE(handle.disconnect());
    EXPECT_FALSE(handle.disconnect());
    signal.emit(1);
    EXPECT_EQ(calls, 1);
    EXPECT_FALSE(Handle().ready());
}

TEST(Signal, MayBeDisconnectedByItsOwnHandlers) {
    IntSignal signal;
    int first = 0, second = 0;
    Handle other;
    Handle self = signal.connect([&](int) {
        ++first;
        self.disconnect();
        other.disconnect();
    });
    other = signal.connect([&](int) { ++second; });
    signal.emit(1);
    signal.emit(1);
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 0);
}

TEST(Signal, ScopedHandleDisconnects) {
    IntSignal signal;
    int calls = 0;
    {
        ScopedHandle scoped(signal.connect([&](int) { ++calls; }));
        signal.emit(1);
    }
    signal.emit(1);
    EXPECT_EQ(calls, 1);
}

TEST(Signal, HandleMayOutliveTheSignal) {
    Handle handle;
    {
        IntSignal signal;
        handle = signal.connect([](int) {});
    }
    EXPECT_FALSE(handle.connected());
    EXPECT_FALSE(handle.connect());
    EXPECT_FALSE(handle.disconnect());
}

TEST(SignalStress, EmittingWhileOthersConnect) {
    IntSignal signal;
    std::atomic<bool> stop{false};
    std::atomic<long> calls{0};
    Handle steady = signal.connect([&](int) { ++calls; });
    std::thread emitter([&] {
        while (!stop) signal.emit(1);
    });
    while (calls == 0) std::this_thread::yield();
    for (int i = 0; i != 2000; ++i) ScopedHandle scoped(signal.connect([&](int) { ++calls; }));
    stop = true;
    emitter.join();
    EXPECT_GT(calls, 0);
}

TEST(OperationSignal, IsEmittedBeforeTheOperationIsExecuted) {
    Probe c;
    std::string order;
    Operation<int(int)>& op = c.addOperation("op", [&](int n) { return order += "op", n; });
    Handle handle = op.signals([&](int n) { order += "signal" + std::to_string(n) + " "; });
    OperationCaller<int(int)> call = c.getOperation("op");
    EXPECT_EQ(call(3), 3);
    EXPECT_EQ(order, "signal3 op");
    handle.disconnect();
    call(4);
    EXPECT_EQ(order, "signal3 opop");
}

TEST(OperationSignal, EventOperationsHaveOne) {
    Probe c;
    int heard = 0;
    auto& op = c.addEventOperation("event", [](int) {});
    op.signals([&](int n) { heard = n; });
    OperationCaller<void(int)> call = c.getOperation("event");
    call(5);
    EXPECT_EQ(heard, 5);
}

}  // namespace
