// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls that a thread makes directly on a slave without master, because it stands for the thread that updates it.
#include "os_test.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/engine/engine_gate.hpp>

#include <memory>
#include <thread>

using namespace RTT;
using oroforge::test::eventually;

namespace {

struct Slave : TaskContext {
    std::atomic<int> inside{0}, together{0}, updates{0};
    std::function<void()> onCall, onUpdate;
    Slave() : TaskContext("slave") {
        setActivity(new extras::SlaveActivity);
        addOperation("call", &Slave::call, this, OwnThread);
    }
    ~Slave() override { stop(); }
    void call() { visit(onCall); }
    void updateHook() override {
        ++updates;
        visit(onUpdate);
    }
    void visit(const std::function<void()>& action) {
        if (++inside != 1) ++together;
        if (action) action();
        --inside;
    }
};

struct SlaveDirectCall : testing::Test {
    Slave slave;
    OperationCaller<void()> call{slave.getOperation("call"), internal::GlobalEngine::Instance()};
};

TEST_F(SlaveDirectCall, IsNotOverlappedByTheFirstUpdate) {
    ASSERT_TRUE(slave.start());
    bool updated = true;
    slave.onCall = [&] { std::thread([&] { updated = slave.update(); }).join(); };
    call();  // in the main thread: nobody has updated it yet
    EXPECT_FALSE(updated);
    EXPECT_EQ(slave.updates, 0);
    EXPECT_EQ(slave.together, 0);
    std::thread([&] { EXPECT_TRUE(slave.update()); }).join();
    EXPECT_EQ(slave.updates, 1);
}

TEST_F(SlaveDirectCall, IsNotOverlappedByUpdatesOfOtherThreads) {
    for (int round = 0; round != 300; ++round) {
        ASSERT_TRUE(slave.getActivity()->isActive() ? slave.getActivity()->stop() : true);
        ASSERT_TRUE(slave.getActivity()->start());  // it belongs to the main thread again
        ASSERT_TRUE(slave.start());
        std::atomic<bool> called{false};
        std::thread other([&] {
            do slave.update();
            while (!called);
        });
        call();
        called = true;
        other.join();
        ASSERT_TRUE(slave.stop());
    }
    EXPECT_EQ(slave.together, 0);
}

TEST_F(SlaveDirectCall, MayCallAnotherOperationOfTheSlave) {
    int inner = 0;
    slave.addOperation(
        "inner", [&] { ++inner; }, OwnThread);
    OperationCaller<void()> second(slave.getOperation("inner"), slave.engine());
    slave.onCall = [&] { second(); };
    call();
    EXPECT_EQ(inner, 1);
}

TEST_F(SlaveDirectCall, ThatThrowsFreesIt) {
    slave.addOperation(
        "throws", [] { throw 1; }, OwnThread);
    OperationCaller<void()> throwing(slave.getOperation("throws"), internal::GlobalEngine::Instance());
    EXPECT_THROW(throwing(), int);
    EXPECT_TRUE(slave.update());
}

TEST_F(SlaveDirectCall, MayExchangeTheActivity) {
    slave.onCall = [&] { EXPECT_TRUE(slave.setActivity(new extras::SlaveActivity)); };
    call();
    EXPECT_TRUE(slave.update());
}

TEST_F(SlaveDirectCall, StopWaitsForItsEnd) {
    std::atomic<bool> inside{false}, left{false};
    slave.onCall = [&] {
        inside = true;
        usleep(20000);
        left = true;
    };
    std::thread other([&] {
        ASSERT_TRUE(eventually([&] { return inside.load(); }));
        EXPECT_TRUE(slave.getActivity()->stop());
        EXPECT_TRUE(left);
    });
    call();
    other.join();
}

TEST(SlaveDirect, CallMayDestroyTheComponent) {
    auto slave = std::make_unique<Slave>();
    OperationCaller<void()> call(slave->getOperation("call"), internal::GlobalEngine::Instance());
    bool* const gone = new bool(false);
    slave->addOperation(
        "end",
        [&slave, gone] {
            slave.reset();
            *gone = true;
        },
        OwnThread);
    OperationCaller<void()> end(slave->getOperation("end"), internal::GlobalEngine::Instance());
    end();
    EXPECT_TRUE(*gone);
    EXPECT_FALSE(call.ready());
    delete gone;
}

// The main thread waits on behalf of the slave and executes its messages, unless another thread is updating it.
TEST_F(SlaveDirectCall, WhatIsExecutedWhileWaitingIsNotOverlappedEither) {
    TaskContext server("server");
    OperationCaller<void()> back(slave.getOperation("call"), server.engine());
    server.addOperation(
        "forward", [&] { back(); }, OwnThread);
    OperationCaller<void()> forward(server.getOperation("forward"), slave.engine());
    forward();  // nobody updates it: served here
    for (int round = 0; round != 100; ++round) {
        ASSERT_TRUE(slave.getActivity()->stop());
        ASSERT_TRUE(slave.getActivity()->start());
        ASSERT_TRUE(slave.start());
        std::atomic<bool> called{false};
        std::thread other([&] {
            do slave.update();
            while (!called);
        });
        forward();
        called = true;
        other.join();
        ASSERT_TRUE(slave.stop());
    }
    EXPECT_EQ(slave.together, 0);
}

}  // namespace

namespace {

/** Exchanges its activity, or destroys itself, in a call that the main thread makes directly. */
struct Changing : TaskContext {
    Changing() : TaskContext("changing") {
        setActivity(new extras::SlaveActivity);
        addOperation("exchange", &Changing::exchange, this, OwnThread);
        addOperation("end", &Changing::end, this, OwnThread);
    }
    bool exchange() { return setActivity(new extras::SlaveActivity); }
    void end() { delete this; }
};

bool othersVisit(const internal::EngineGate& gate) {
    bool others = true;
    std::thread([&] { others = internal::Presence::Waiter(&gate).others(); }).join();
    return others;
}

}  // namespace

TEST(SlaveDirect, CallThatExchangesTheActivityIsOverAfterwards) {
    Changing component;
    OperationCaller<bool()> exchange(component.getOperation("exchange"), internal::GlobalEngine::Instance());
    EXPECT_TRUE(exchange());
    EXPECT_FALSE(othersVisit(*component.engine()->gate()));
    std::thread([&] { EXPECT_TRUE(component.setActivity(new extras::SlaveActivity)); }).join();
}

TEST(SlaveDirect, CallThatDestroysTheComponentIsOverAfterwards) {
    Slave outer;
    auto* const component = new Changing;
    const boost::intrusive_ptr<const internal::EngineGate> gate = component->engine()->gate();
    OperationCaller<void()> end(component->getOperation("end"), internal::GlobalEngine::Instance());
    {
        const internal::EngineGate::Visit visit(*outer.engine()->gate());
        end();
        EXPECT_FALSE(othersVisit(*gate));
        EXPECT_TRUE(othersVisit(*outer.engine()->gate()));
    }
    EXPECT_FALSE(othersVisit(*outer.engine()->gate()));
}
