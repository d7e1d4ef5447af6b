// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls that come back to the thread that waits, by ways that the caller's engine alone does not see.
#include "probe.hpp"

#include <rtt/SendHandle.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <cstdint>
#include <memory>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

struct Cycle : testing::Test {
    Probe x{"x"}, y{"y"}, z{"z"};
    std::atomic<int> served{0};
    OperationCaller<void()> toX, toZ;

    Cycle() {
        x.addOperation(
            "back", [this] { ++served; }, OwnThread);
        toX = OperationCaller<void()>(x.getOperation("back"), z.engine());
        z.addOperation(
            "forward", [this] { toX(); }, OwnThread);
    }
    /** Runs `action` in the thread of x and says whether it came back. */
    bool inX(std::function<void()> action) {
        std::atomic<bool> done{false};
        x.onUpdate = [&] {
            action();
            done = true;
        };
        if (!x.start() || !eventually([&] { return done.load(); })) return false;
        const bool stopped = x.stop();
        x.onUpdate = nullptr;
        return stopped;
    }
};

TEST_F(Cycle, ThroughAnOperationThatThisThreadExecutesForAnother) {
    toZ = OperationCaller<void()>(z.getOperation("forward"), y.engine());
    y.addOperation("middle", [this] { toZ(); });  // in the thread of the client
    OperationCaller<void()> middle(y.getOperation("middle"), x.engine());
    EXPECT_TRUE(inX([&] { middle(); }));
    EXPECT_EQ(served, 1);
}

TEST_F(Cycle, ThroughACallerOfTheGlobalEngine) {
    toZ = OperationCaller<void()>(z.getOperation("forward"), internal::GlobalEngine::Instance());
    EXPECT_TRUE(inX([&] { EXPECT_EQ(toZ.send().collect(), SendSuccess); }));
    EXPECT_EQ(served, 1);
}

TEST_F(Cycle, OfASlaveToItsMaster) {
    Probe slave("slave");
    ASSERT_TRUE(slave.setActivity(new extras::SlaveActivity(x.getActivity())));
    toZ = OperationCaller<void()>(z.getOperation("forward"), slave.engine());
    slave.onUpdate = [this] { toZ(); };
    ASSERT_TRUE(slave.start());
    EXPECT_TRUE(inX([&] { EXPECT_TRUE(slave.update()); }));
    EXPECT_GE(served, 1);
    EXPECT_TRUE(slave.stop());
    slave.getActivity()->stop();
    slave.onUpdate = nullptr;
}

TEST_F(Cycle, OfTheGlobalEngineToItself) {
    x.addOperation("inner", [this] { ++served; });
    OperationCaller<void()> inner(x.getOperation("inner"), internal::GlobalEngine::Instance());
    x.addOperation("outer", [&] { EXPECT_EQ(inner.send().collect(), SendSuccess); });
    OperationCaller<void()> outer(x.getOperation("outer"), internal::GlobalEngine::Instance());
    EXPECT_EQ(outer.send().collect(), SendSuccess);
    EXPECT_EQ(served, 1);
}

class Destroying : public Cycle, public testing::WithParamInterface<bool> {};

// z destroys a component that another thread executes, which waits for z.
TEST_P(Destroying, ServesTheThreadItWaitsFor) {
    auto victim = std::make_unique<Probe>("victim");
    if (GetParam()) {
        ASSERT_TRUE(victim->setActivity(new extras::SequentialActivity()));
    } else {
        victim->getActivity()->thread()->setStopTimeout(0.05);
    }
    std::atomic<bool> inside{false}, destroying{false}, destroyed{false};
    z.addOperation(
        "serve", [this] { ++served; }, OwnThread);
    OperationCaller<void()> serve(z.getOperation("serve"), victim->engine());
    victim->addOperation(
        "work",
        [&] {
            inside = true;
            while (!destroying) usleep(100);
            usleep(2000);
            serve();
        },
        OwnThread);
    OperationCaller<void()> work(victim->getOperation("work"), internal::GlobalEngine::Instance());
    std::thread worker([&] { work(); });
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    z.onUpdate = [&] {
        destroying = true;
        victim.reset();
        destroyed = true;
    };
    ASSERT_TRUE(z.start());
    EXPECT_TRUE(eventually([&] { return destroyed.load(); }));
    worker.join();
    EXPECT_EQ(served, 1);
    z.onUpdate = nullptr;
}
INSTANTIATE_TEST_SUITE_P(Sequential, Destroying, testing::Bool());

struct alignas(64) Wide {
    double values[8] = {};
};

TEST(CallArguments, KeepTheirAlignment) {
    Probe server("server");
    std::atomic<std::uintptr_t> at{1};
    server.addOperation(
        "take",
        [&](const Wide& wide) {
            at = reinterpret_cast<std::uintptr_t>(&wide);
            return wide;
        },
        OwnThread);
    OperationCaller<Wide(const Wide&)> take(server.getOperation("take"), internal::GlobalEngine::Instance());
    for (int i = 0; i != 8; ++i) {
        Wide wide;
        wide.values[3] = i;
        EXPECT_EQ(take(wide).values[3], i);
        EXPECT_EQ(at % alignof(Wide), 0u);
    }
}

TEST(RefusedCall, SaysWhoRefusedItAndWhy) {
    Probe server("the_server");
    server.addOperation(
        "op", [] {}, OwnThread);
    OperationCaller<void()> op(server.getOperation("op"), internal::GlobalEngine::Instance());
    server.fatal();
    try {
        op();
        FAIL();
    } catch (const SendError& error) {
        EXPECT_NE(std::string(error.what()).find("the_server"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("FatalError"), std::string::npos) << error.what();
    }
}

}  // namespace
