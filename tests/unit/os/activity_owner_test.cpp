// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Activities that are made with a runnable which another activity has already.
#include "logger_capture.hpp"
#include "message_runner.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/Activities.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <memory>
#include <stdexcept>
#include <thread>

using namespace RTT;
using oroforge::test::CountingRunner;
using oroforge::test::eventually;
using oroforge::test::LoggerCapture;

namespace {

struct Component : TaskContext {
    std::atomic<int> updates{0};
    Component() : TaskContext("component") {
        addOperation(
            "echo", [](int n) { return n; }, OwnThread);
    }
    ~Component() override { stop(); }
    void updateHook() override { ++updates; }
};

/** Calls the component's operation until told to stop. */
class Calls {
public:
    explicit Calls(Component& c)
        : echo_(c.getOperation("echo"), internal::GlobalEngine::Instance()), thread_([this] { run(); }) {}
    ~Calls() {
        stop_ = true;
        thread_.join();
    }
    std::atomic<int> done{0}, refused{0};

private:
    void run() {
        for (int i = 0; !stop_; ++i) {
            try {
                echo_(i) == i ? ++done : ++refused;
            } catch (const std::runtime_error&) {
                ++refused;
            }
        }
    }
    OperationCaller<int(int)> echo_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

TEST(ActivityOfABusyRunner, LeavesItToTheOneThatHasIt) {
    CountingRunner r;
    Activity first(&r);
    ASSERT_TRUE(first.start());
    {
        Activity second(&r);
        EXPECT_EQ(second.getRunner(), &r);
        EXPECT_EQ(r.getActivity(), &first);
    }
    EXPECT_EQ(r.getActivity(), &first);
    const int triggers = r.triggers;
    EXPECT_TRUE(r.getActivity()->trigger());
    EXPECT_TRUE(eventually([&] { return r.triggers > triggers; }));
    EXPECT_TRUE(first.stop());
}

TEST(ActivityOfABusyRunner, TakesItOverWhenItStarts) {
    CountingRunner r;
    Activity first(&r);
    ASSERT_TRUE(first.start());
    Activity second(ORO_SCHED_OTHER, 0, 0.002, &r);
    ASSERT_TRUE(second.start());
    EXPECT_FALSE(first.isActive());
    EXPECT_EQ(r.getActivity(), &second);
    EXPECT_EQ(r.initialized, 2);
    EXPECT_EQ(r.finalized, 1);
    EXPECT_TRUE(eventually([&] { return r.timeouts >= 2; }));
    ASSERT_TRUE(first.start());  // and back again
    EXPECT_FALSE(second.isActive());
    EXPECT_EQ(r.getActivity(), &first);
    EXPECT_TRUE(first.stop());
    EXPECT_EQ(r.initialized, 3);
    EXPECT_EQ(r.finalized, 3);
}

TEST(ActivityOfABusyRunner, EveryKindTakesItOver) {
    CountingRunner r;
    Activity first(&r);
    std::unique_ptr<base::ActivityInterface> others[] = {
        std::make_unique<extras::SequentialActivity>(&r),
        std::make_unique<extras::SlaveActivity>(0.1, &r),
        std::make_unique<extras::PeriodicActivity>(ORO_SCHED_OTHER, 0, 0.002, &r),
        std::make_unique<extras::FileDescriptorActivity>(ORO_SCHED_OTHER, 0, &r),
        std::make_unique<extras::SimulationActivity>(0.001, &r),
    };
    for (auto& other : others) {
        ASSERT_TRUE(first.start());
        ASSERT_EQ(r.getActivity(), &first);
        EXPECT_TRUE(other->start());
        EXPECT_EQ(r.getActivity(), other.get());
        EXPECT_FALSE(first.isActive());
        EXPECT_TRUE(other->stop());
    }
    EXPECT_EQ(r.initialized, r.finalized);
}

TEST(ActivityOfABusyRunner, DoesNotStartIfTheOtherOneDoesNotStop) {
    const LoggerCapture log;
    CountingRunner r;
    std::atomic<bool> inside{false}, leave{false};
    r.onLoop = [&] {
        inside = true;
        eventually([&] { return leave.load(); });
    };
    r.breakResult = false;
    Activity first(&r);
    ASSERT_TRUE(first.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    Activity second(&r);
    EXPECT_FALSE(second.start());
    EXPECT_EQ(log.count("belongs to another one, which does not stop"), 1);
    EXPECT_TRUE(first.isActive());
    EXPECT_EQ(r.getActivity(), &first);
    leave = true;
    r.breakResult = true;
    EXPECT_TRUE(eventually([&] { return second.start(); }));
    EXPECT_TRUE(eventually([&] { return second.stop(); }));
}

TEST(ActivityOfABusyRunner, DoesNotStartWithinAStepOfTheOtherOne) {
    const LoggerCapture log;
    CountingRunner r;
    Activity first(&r), second(&r);
    std::atomic<int> started{-1};
    r.onWork = [&](auto) { started = second.start(); };
    ASSERT_TRUE(first.start());
    EXPECT_TRUE(eventually([&] { return started != -1; }));
    EXPECT_EQ(started, 0);
    EXPECT_TRUE(first.isActive());
    EXPECT_EQ(log.count("belongs to another one, whose thread calls start()"), 1);
    EXPECT_TRUE(eventually([&] { return first.stop(); }));
}

TEST(ActivityOfABusyRunner, MayOutliveARunnerThatOthersTook) {
    auto r = std::make_unique<CountingRunner>();
    Activity first(r.get());
    Activity second(r.get());
    Activity third(r.get());
    ASSERT_TRUE(second.start());
    EXPECT_TRUE(second.stop());
    EXPECT_TRUE(third.run(r.get()));
    EXPECT_EQ(r->getActivity(), &third);
    r.reset();
    EXPECT_EQ(third.getRunner(), nullptr);
}

TEST(ActivityOfABusyRunner, MayBeMadeAndDestroyedWhileOthersSend) {
    Component c;
    Calls calls(c);
    for (int i = 0; i != 100; ++i) {
        const int before = calls.done;
        const auto other = std::make_unique<Activity>(ORO_SCHED_OTHER, 0, 0.0, c.engine());
        ASSERT_TRUE(eventually([&] { return calls.done > before + 2; })) << "nobody executes";
    }
    EXPECT_EQ(calls.refused, 0);
    EXPECT_EQ(c.engine()->getActivity(), c.getActivity());
}

TEST(ActivityOfABusyRunner, MayBecomeThatOfTheComponentWhileOthersSend) {
    Component c;
    Calls calls(c);
    for (int i = 0; i != 30; ++i) {
        const int before = calls.done;
        ASSERT_TRUE(c.setActivity(new Activity(ORO_SCHED_OTHER, 0, 0.01 * (i % 2), c.engine(), "made_with_engine")));
        ASSERT_TRUE(eventually([&] { return calls.done > before + 2; })) << "nobody executes";
    }
    EXPECT_EQ(calls.refused, 0);
}

TEST(ActivityOfABusyRunner, OfAComponentThatDoesNotOwnIt) {
    Component c;
    {
        Activity mine(ORO_SCHED_OTHER, 0, 0.002, c.engine());
        ASSERT_TRUE(c.start());
        ASSERT_TRUE(mine.start());
        EXPECT_FALSE(c.getActivity()->isActive());
        const int before = c.updates;
        EXPECT_TRUE(eventually([&] { return c.updates >= before + 3; }));
        EXPECT_TRUE(c.isActive());
        EXPECT_TRUE(c.stop());
        EXPECT_TRUE(mine.stop());
    }
    EXPECT_TRUE(c.setActivity(new extras::SequentialActivity));
    EXPECT_TRUE(c.start());
}

}  // namespace
