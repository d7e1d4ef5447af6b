// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Changes of state while another thread executes or changes the component, and what ends or outlives it.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <optional>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Note;
using oroforge::test::Probe;

namespace {

constexpr TaskContext::TaskState kStopped = TaskContext::Stopped, kRunning = TaskContext::Running;

/** updateHook() that does not return until it is told to. */
struct Stubborn : Probe {
    explicit Stubborn(bool breaks) : Probe("stubborn"), breaks_(breaks) {
        getActivity<Activity>()->setStopTimeout(0.03);
        onUpdate = [this] {
            inside = true;
            while (!release) usleep(200);
        };
    }
    ~Stubborn() override {
        release = true;
        getActivity()->stop();
    }
    bool breakUpdateHook() override { return breaks_; }
    std::atomic<bool> inside{false}, release{false};

private:
    bool breaks_;
};

class StopFails : public testing::TestWithParam<bool> {};

// Refused by breakUpdateHook(), or promised by it and not kept within the stop timeout.
TEST_P(StopFails, AndTheComponentGoesOn) {
    Stubborn component(GetParam());
    ASSERT_TRUE(component.start());
    ASSERT_TRUE(eventually([&] { return component.inside.load(); }));
    EXPECT_FALSE(component.stop());
    EXPECT_EQ(component.getTaskState(), kRunning);
    EXPECT_EQ(component.getTargetState(), kRunning);
    EXPECT_EQ(component.takeHooks(), "start");
    component.release = true;
    EXPECT_TRUE(eventually([&] { return component.updates >= 1; }));
    EXPECT_TRUE(component.stop());
    EXPECT_EQ(component.takeHooks(), "stop");
}
INSTANTIATE_TEST_SUITE_P(BreakUpdateHook, StopFails, testing::Bool());

TEST(ChangeOfState, OfOtherThreadsIsRefusedWhileOneIsUnderWay) {
    Probe probe("probe", TaskContext::PreOperational);
    std::atomic<bool> inside{false}, release{false};
    probe.onConfigure = [&] {
        inside = true;
        while (!release) usleep(200);
        return true;
    };
    std::atomic<int> result{-1};
    std::thread first([&] { result = probe.configure(); });
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(probe.configure());
    EXPECT_FALSE(probe.start());
    EXPECT_EQ(result, -1);
    release = true;
    first.join();
    EXPECT_EQ(result, 1);
    EXPECT_EQ(probe.takeHooks(), "configure");
    EXPECT_TRUE(probe.start()) << "the claim has ended";
}

TEST(ChangeOfState, MayComeOutOfTheExceptionHook) {
    Probe probe;
    probe.onException = [&] { EXPECT_TRUE(probe.recover() && probe.start()); };
    ASSERT_TRUE(probe.start());
    probe.exception();
    EXPECT_EQ(probe.getTaskState(), kRunning);
    EXPECT_EQ(probe.takeHooks(), "start stop exception start");
}

// The first updateHook() of a component may want to stop it before start() has returned in its caller.
TEST(ChangeOfState, StopOfTheFirstStepSucceeds) {
    for (int round = 0; round != 200; ++round) {
        Probe probe;
        std::atomic<int> result{-1};
        probe.onUpdate = [&] {
            if (result == -1) result = probe.stop();
        };
        ASSERT_TRUE(probe.start());
        ASSERT_TRUE(eventually([&] { return result != -1; }));
        ASSERT_EQ(result, 1);
    }
}

TEST(ChangeOfState, IsNotUndoneByAnExceptionOfTheOwnThread) {
    Probe probe("probe", TaskContext::PreOperational);
    probe.addOperation(
        "bad", [] { throw 42; }, OwnThread);
    OperationCaller<void()> bad(probe.getOperation("bad"), internal::GlobalEngine::Instance());
    ASSERT_TRUE(probe.configure());
    probe.onStart = [&] {
        EXPECT_THROW(bad(), std::runtime_error);
        return true;
    };
    probe.takeHooks();
    EXPECT_FALSE(probe.start());
    EXPECT_TRUE(probe.inException());
    EXPECT_EQ(probe.takeHooks(), "start cleanup exception") << "each of them once";
    EXPECT_TRUE(probe.recover());
    EXPECT_EQ(probe.getTaskState(), TaskContext::PreOperational);
    EXPECT_EQ(probe.getTargetState(), TaskContext::PreOperational);
}

TEST(ChangeOfState, ErrorDuringStopHookIsIgnored) {
    Probe probe;
    ASSERT_TRUE(probe.start());
    probe.onStop = [&] { std::thread([&] { probe.error(); }).join(); };
    EXPECT_TRUE(probe.stop());
    EXPECT_EQ(probe.getTaskState(), kStopped);
}

TEST(ChangeOfState, StartHookThatCallsErrorAndRefusesLeavesItStopped) {
    Probe probe;
    probe.onStart = [&] { return probe.error(), false; };
    EXPECT_FALSE(probe.start());
    EXPECT_EQ(probe.getTaskState(), kStopped);
    EXPECT_EQ(probe.getTargetState(), kStopped);
}

TEST(ChangeOfState, HookThatEntersExceptionAndReturnsTrueCallsExceptionHookOnce) {
    Probe probe;
    probe.onStart = [&] { return probe.exception(), true; };
    EXPECT_FALSE(probe.start());
    EXPECT_TRUE(probe.inException());
    EXPECT_EQ(probe.takeHooks(), "start exception");
}

TEST(ChangeOfState, StormOfErrorsAndRecoveriesDoesNotHinderStop) {
    Probe probe;
    std::atomic<bool> end{false};
    std::thread other([&] {
        while (!end)
            if (probe.isRunning()) {
                probe.error();
                probe.recover();
            }
    });
    Attribute<bool>(probe.getAttribute("TriggerOnStart")).set(false);
    for (int i = 0; i != 500; ++i) {
        if (!probe.start()) {
            // error() came within startHook(): a contradiction, by definition. The other thread may have recovered already.
            probe.recover();
            ASSERT_EQ(probe.getTaskState(), kStopped);
            continue;
        }
        ASSERT_TRUE(probe.stop());
        ASSERT_EQ(probe.getTaskState(), kStopped);
    }
    end = true;
    other.join();
}

// getActivity()->stop(), in a destructor say, waits for a step though the component has stopped its own thread in it.
TEST(StoppedByItself, IsWaitedFor) {
    Probe probe;
    std::atomic<bool> failed{false}, ended{false};
    probe.onUpdate = [&] {
        probe.fatal();
        failed = true;
        usleep(10000);
        ended = true;
    };
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return failed.load(); }));
    probe.getActivity()->stop();
    EXPECT_TRUE(ended);
}

TEST(SetPeriod, ExecutesOneTriggerStep) {
    Probe probe;
    const auto triggers = [&] { return Attribute<unsigned>(probe.getAttribute("TriggerCounter")).get(); };
    probe.getActivity()->stop();
    const unsigned before = triggers();
    ASSERT_TRUE(probe.activate());
    ASSERT_TRUE(probe.setPeriod(100.0));
    EXPECT_FALSE(probe.setPeriod(-1.0));
    usleep(20000);
    probe.getActivity()->stop();
    EXPECT_GT(triggers(), before);
}

TEST(WaitForMessages, InAnotherThreadEndsWithWhatAMessageDoes) {
    Probe probe;
    std::atomic<bool> go{false}, effect{false};
    Note message([&] {
        while (!go) usleep(200);
        effect = true;
    });
    ASSERT_TRUE(probe.engine()->process(&message));
    std::atomic<bool> returned{false};
    std::thread waiter([&] {
        probe.engine()->waitForMessages([&] { return effect.load(); });
        returned = true;
    });
    usleep(5000);
    EXPECT_FALSE(returned);
    go = true;
    waiter.join();
    EXPECT_TRUE(effect);
}

/** Reads its port whatever its state. */
struct AlwaysAwake : Probe {
    InputPort<int> in{"in"};
    std::atomic<int> calls{0};
    AlwaysAwake() : Probe("awake") {
        addEventPort(in, [this](base::PortInterface*) { ++calls; });
    }
    ~AlwaysAwake() override { getActivity()->stop(); }
    bool dataOnPortHook(base::PortInterface*) override { return true; }
};

TEST(DataOnPortHook, MayAskForCallbacksWhileNotRunning) {
    AlwaysAwake component;
    OutputPort<int> out("out");
    ASSERT_TRUE(out.connectTo(&component.in));
    out.write(1);
    EXPECT_TRUE(eventually([&] { return component.calls == 1; }));
    EXPECT_EQ(component.getTaskState(), kStopped);
}

TEST(Destructor, CallsNoHookAndFreesWhoHoldsItsServices) {
    struct Plain : TaskContext {
        explicit Plain(std::string& hooks) : TaskContext("plain"), hooks_(hooks) {
            setActivity(new extras::SequentialActivity());  // a thread would meet a half destroyed object
        }
        void stopHook() override { hooks_ += "stop"; }
        void cleanupHook() override { hooks_ += "cleanup"; }
        std::string& hooks_;
    };
    std::string hooks;
    std::optional<Plain> component(std::in_place, hooks);
    ASSERT_TRUE(component->start());
    const Service::shared_ptr service = component->provides();
    const Service::shared_ptr sub = component->provides("sub");
    EXPECT_EQ(sub->getOwner(), &*component);
    component.reset();
    EXPECT_EQ(hooks, "");
    EXPECT_EQ(service->getOwner(), nullptr);
    EXPECT_EQ(sub->getOwner(), nullptr);
    EXPECT_FALSE(service->hasOperation("start"));
}

}  // namespace
