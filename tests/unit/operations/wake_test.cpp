// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An event port write, an OwnThread operation or trigger() costs at most one wake-up of the component's thread, none if it
// is awake, and is never lost.
#include "futex_count.hpp"
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/internal/GlobalEngine.hpp>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::futexWakes;
using oroforge::test::isAsleep;
using oroforge::test::Probe;

namespace {

struct Wakes : testing::Test {
    Probe target{"target"};
    InputPort<int> in{"in"};
    OutputPort<int> out{"out"};
    std::atomic<long> executed{0}, calls{0};
    OperationCaller<void()> count;
    int tid = 0;

    Wakes() {
        target.addEventPort(in, [this](base::PortInterface*) {
            int sample = 0;
            if (in.read(sample) == NewData) ++calls;
        });
        target.addOperation(
            "count", [this] { ++executed; }, OwnThread);
        count = OperationCaller<void()>(target.getOperation("count"), internal::GlobalEngine::Instance());
        EXPECT_TRUE(out.connectTo(&in));
        EXPECT_TRUE(target.start());
        EXPECT_TRUE(eventually([this] { return target.updates == 1; }));
        tid = static_cast<int>(target.getActivity<Activity>()->getPid());
    }
    ~Wakes() override {
        target.stop();
        target.ports()->removePort("in");
    }
    /** Not only on its way to sleep. */
    void waitUntilAsleep() {
        ASSERT_TRUE(eventually([this] { return isAsleep(tid); }));
    }
    /** Keeps the target awake in its updateHook() until `release` is set. */
    void keepAwake(std::atomic<bool>& release) {
        inside = false;
        target.onUpdate = [&] {
            inside = true;
            while (!release) std::this_thread::yield();
        };
        ASSERT_TRUE(target.trigger());
        ASSERT_TRUE(eventually([&] { return inside.load(); }));
    }
    std::atomic<bool> inside{false};
};

TEST_F(Wakes, EachOfThemWakesASleepingComponentWithOneSystemCall) {
    for (int round = 0; round != 20; ++round) {
        waitUntilAsleep();
        long before = futexWakes();
        target.trigger();
        ASSERT_TRUE(eventually([&] { return target.updates == 2 + round; }));
        waitUntilAsleep();
        EXPECT_EQ(futexWakes(), before + 1) << "trigger()";

        before = futexWakes();
        count.send();
        ASSERT_TRUE(eventually([&] { return executed == round + 1; }));
        waitUntilAsleep();
        EXPECT_EQ(futexWakes(), before + 1) << "operation";

        before = futexWakes();
        out.write(round);
        ASSERT_TRUE(eventually([&] { return calls == round + 1; }));
        waitUntilAsleep();
        EXPECT_EQ(futexWakes(), before + 1) << "event port";
    }
}

TEST_F(Wakes, AComponentThatIsAwakeIsNotWoken) {
    std::atomic<bool> release{false};
    keepAwake(release);
    const int updates = target.updates;
    const long before = futexWakes();
    for (int i = 0; i != 100; ++i) {
        target.trigger();
        count.send();
        out.write(i);
    }
    EXPECT_EQ(futexWakes(), before);
    release = true;
    EXPECT_TRUE(eventually([&] { return executed == 100 && calls >= 1 && target.updates > updates + 1; }));
    target.stop();
}

TEST_F(Wakes, AComponentThatWaitsInACallIsWokenForMessagesButNotForPorts) {
    Probe server("server");
    std::atomic<bool> release{false}, inside{false}, returned{false};
    server.addOperation(
        "wait",
        [&] {
            inside = true;
            while (!release) std::this_thread::yield();
        },
        OwnThread);
    OperationCaller<void()> wait(server.getOperation("wait"), target.engine());
    target.onUpdate = [&] {
        wait();
        returned = true;
    };
    ASSERT_TRUE(target.trigger());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    waitUntilAsleep();

    long before = futexWakes();
    out.write(1);
    EXPECT_EQ(futexWakes(), before);
    EXPECT_TRUE(isAsleep(tid));
    count.send();
    EXPECT_TRUE(eventually([&] { return executed == 1; })) << "executed while it waits";
    waitUntilAsleep();
    EXPECT_EQ(futexWakes(), before + 1);
    EXPECT_EQ(calls, 0) << "the callback of the port is put off";
    EXPECT_FALSE(returned);

    target.onUpdate = nullptr;
    release = true;
    EXPECT_TRUE(eventually([&] { return calls == 1; })) << "and not lost";
    EXPECT_TRUE(returned);
}

TEST_F(Wakes, InAStormEachCostsAtMostOneAndNothingIsLost) {
    constexpr int kThreads = 3, kEach = 2000;
    waitUntilAsleep();
    const long wakesBefore = futexWakes();
    std::atomic<long> accepted{0};
    std::vector<std::thread> threads;
    for (int t = 0; t != kThreads; ++t)
        threads.emplace_back([&, t] {
            OperationCaller<void()> mine(target.getOperation("count"), internal::GlobalEngine::Instance());
            for (int i = 0; i != kEach; ++i) {
                if (mine.send().ready()) ++accepted;
                target.trigger();
                if (t == 0) out.write(i);
                if (i % 16 == 0) std::this_thread::yield();
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(eventually([&] { return executed == accepted; }));
    EXPECT_TRUE(eventually([&] { return calls >= 1; }));
    waitUntilAsleep();
    constexpr long kTriggersAndWrites = kThreads * kEach + kEach;
    EXPECT_LE(futexWakes() - wakesBefore, accepted + kTriggersAndWrites);
}

// The next one is sent the moment the previous one was executed, that is while the thread is about to go to sleep.
TEST_F(Wakes, NoneIsLostWhenItComesWhileTheThreadFallsAsleep) {
    for (int i = 1; i <= 3000; ++i) {
        const auto soon = [&](const std::function<bool()>& done) {
            for (int spin = 0; spin != 2000; ++spin)
                if (done()) return true;
            return eventually(done);
        };
        target.trigger();
        ASSERT_TRUE(soon([&] { return target.updates == i + 1; })) << i;
        count.send();
        ASSERT_TRUE(soon([&] { return executed == i; })) << i;
        out.write(i);
        ASSERT_TRUE(soon([&] { return calls == i; })) << i;
    }
}

TEST_F(Wakes, ACallCostsTwo) {
    constexpr int kCalls = 200;
    Probe client("client");
    OperationCaller<void()> call(target.getOperation("count"), client.engine());
    std::atomic<long> cost{-1};
    client.onUpdate = [&] {
        const long before = futexWakes();
        for (int i = 0; i != kCalls; ++i) call();
        cost = futexWakes() - before;
    };
    ASSERT_TRUE(client.start());
    ASSERT_TRUE(eventually([&] { return cost >= 0; }));
    EXPECT_LE(cost, 2 * kCalls) << "one for the component that is called, one for the caller";
    client.stop();
}

TEST_F(Wakes, ThreadsThatAreNoComponentsDoNotWakeEachOther) {
    constexpr int kThreads = 4, kCalls = 300;
    const long before = futexWakes();
    std::vector<std::thread> threads;
    for (int t = 0; t != kThreads; ++t)
        threads.emplace_back([&] {
            OperationCaller<void()> call(target.getOperation("count"), internal::GlobalEngine::Instance());
            for (int i = 0; i != kCalls; ++i) call();
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(executed, kThreads * kCalls);
    EXPECT_LE(futexWakes() - before, 2 * kThreads * kCalls);
}

}  // namespace
