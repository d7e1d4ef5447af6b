// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// stop() of a component that is called within its own updateHook() or errorHook(), and recover() while stop() is under way.
#include "probe.hpp"

#include <rtt/extras/Activities.hpp>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

/** Is asked whether its hook breaks. */
struct Breaking : Probe {
    ~Breaking() override { end(); }
    /** A subclass with own hooks calls it in its destructor, while these hooks still are there for the thread. */
    void end() {
        breaks = true;
        stop();
        getActivity()->stop();
    }
    bool breakUpdateHook() override { return ++asked, breaks; }
    std::atomic<int> asked{0};
    std::atomic<bool> breaks{false};
};

/** Cannot say whether its hook breaks, until the test ends. */
struct Throwing : Breaking {
    ~Throwing() override { end(); }
    bool breakUpdateHook() override {
        if (breaks) return true;
        throw 1;
    }
};

struct StopWithin : testing::TestWithParam<const char*> {
    std::atomic<int> result{-1};  // hooks write it as long as the component lives
    Breaking component;
    const std::string kind = GetParam();

    void SetUp() override { ASSERT_TRUE(component.setActivity(make())); }
    ~StopWithin() override { extras::SimulationThread::Release(); }
    base::ActivityInterface* make() {
        if (kind == "periodic") return new Activity(ORO_SCHED_OTHER, 0, 0.002);
        if (kind == "shared") return new extras::PeriodicActivity(ORO_SCHED_OTHER, 0, 0.002);
        if (kind == "sequential") return new extras::SequentialActivity;
        if (kind == "slave") return new extras::SlaveActivity;
        if (kind == "periodic_slave") return new extras::SlaveActivity(0.002);
        if (kind == "simulation") return new extras::SimulationActivity(0.001);
        if (kind == "descriptors") return new extras::FileDescriptorActivity(ORO_SCHED_OTHER, 0);
        return new Activity(ORO_SCHED_OTHER, 0, 0.0);
    }
    /** Has a step executed, by whoever does that for this kind. */
    void step() {
        if (kind == "slave" || kind == "periodic_slave" || kind == "simulation")
            component.update();
        else
            component.trigger();
    }
    bool stepsUntil(const std::function<bool()>& done) {
        return eventually([&] {
            if (!done()) step();
            return done();
        });
    }
};

TEST_P(StopWithin, UpdateHookAsksBreakUpdateHookAndGoesOnIfThatIsFalse) {
    component.onUpdate = [&] {
        if (result == -1) result = component.stop();
    };
    ASSERT_TRUE(component.start());
    ASSERT_TRUE(stepsUntil([&] { return component.updates >= 2; }));
    EXPECT_EQ(result, 0);
    EXPECT_EQ(component.asked, 1);
    EXPECT_EQ(component.getTaskState(), TaskContext::Running);
    EXPECT_EQ(component.getTargetState(), TaskContext::Running);
    EXPECT_TRUE(component.isActive());
    EXPECT_EQ(component.takeHooks(), "start");
}

TEST_P(StopWithin, UpdateHookStopsIfBreakUpdateHookIsTrue) {
    component.breaks = true;
    component.onUpdate = [&] { result = component.stop(); };
    ASSERT_TRUE(component.start());
    ASSERT_TRUE(stepsUntil([&] { return component.updates == 1; }));
    EXPECT_EQ(result, 1);
    EXPECT_EQ(component.asked, 1);
    EXPECT_EQ(component.getTaskState(), TaskContext::Stopped);
    EXPECT_EQ(component.takeHooks(), "start stop");
    component.onUpdate = nullptr;
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(stepsUntil([&] { return component.updates >= 2; }));
}

TEST_P(StopWithin, ErrorHookAsksToo) {
    component.onUpdate = [&] { component.error(); };
    component.onError = [&] {
        if (result == -1) result = component.stop();
    };
    ASSERT_TRUE(component.start());
    ASSERT_TRUE(stepsUntil([&] { return component.errors >= 2; }));
    EXPECT_EQ(result, 0);
    EXPECT_EQ(component.asked, 1);
    EXPECT_TRUE(component.inRunTimeError());
}

TEST_P(StopWithin, RecoverIsFalseInTheStopHook) {
    component.breaks = true;
    ASSERT_TRUE(component.start());
    component.error();
    bool recovered = true;
    component.onStop = [&] { recovered = component.recover(); };
    EXPECT_TRUE(component.stop());
    EXPECT_FALSE(recovered);
    EXPECT_EQ(component.getTaskState(), TaskContext::Stopped);
}
INSTANTIATE_TEST_SUITE_P(Kinds, StopWithin,
                         testing::Values("triggered", "periodic", "shared", "sequential", "slave", "periodic_slave",
                                         "simulation", "descriptors"),
                         [](const auto& info) { return std::string(info.param); });

TEST(StopOfTheActivity, InUpdateHookAsksBreakUpdateHook) {
    std::atomic<int> result{-1};
    Breaking component;
    component.onUpdate = [&] {
        if (result == -1) result = component.getActivity()->stop();
    };
    ASSERT_TRUE(component.start());
    ASSERT_TRUE(eventually([&] { return component.trigger() && component.updates >= 2; }));
    EXPECT_EQ(result, 0);
    EXPECT_EQ(component.asked, 1);
    EXPECT_TRUE(component.isActive());
}

TEST(RefusedStop, FromWithinExecutesNothingTwice) {
    Breaking component;
    component.onUpdate = [&] { EXPECT_FALSE(component.getActivity()->stop()); };
    ASSERT_TRUE(component.start());
    ASSERT_TRUE(eventually([&] { return component.updates == 1; }));
    usleep(5000);
    EXPECT_EQ(component.updates, 1);
    component.breaks = true;
    component.onUpdate = nullptr;
    EXPECT_TRUE(component.stop());
    EXPECT_TRUE(component.isActive());
}

TEST(RefusedStop, ByBreakUpdateHookThatThrowsIsAnException) {
    Throwing component;
    component.onUpdate = [&] { component.stop(); };
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(eventually([&] { return component.inException(); }));
    EXPECT_TRUE(eventually([&] { return component.takeHooks().find("exception") != std::string::npos; }));
}

TEST(RefusedStop, ByBreakUpdateHookThatThrowsIsTakenBack) {
    Throwing component;
    component.onUpdate = [&] {
        if (component.updates == 0) EXPECT_ANY_THROW(component.stop());
    };
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(eventually([&] { return component.trigger() && component.updates >= 2; }));
    EXPECT_EQ(component.getTargetState(), TaskContext::Running);
}

// There is no updateHook() that could go on.
TEST(FatalError, EndsTheActivityThoughBreakUpdateHookIsFalse) {
    Breaking component;
    component.onUpdate = [&] { component.fatal(); };
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(eventually([&] { return !component.isActive(); }));
    EXPECT_EQ(component.asked, 0);
}

TEST(StopOfTheActivity, InExceptionHookDoesNotAskBreakUpdateHook) {
    std::atomic<int> result{-1};
    Breaking component;
    component.onUpdate = [] { throw 1; };
    component.onException = [&] { result = component.getActivity()->stop(); };
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(eventually([&] { return result != -1; }));
    EXPECT_EQ(result, 1);
    EXPECT_EQ(component.asked, 0);
}

TEST(Recover, HasWhatStoodStillExecuted) {
    struct Pausing : oroforge::test::Steps {
        using Steps::Steps;
        bool pausesInException() const override { return true; }
    };
    Probe component;
    Pausing pausing([] { return true; });
    oroforge::test::Steps other([] { return true; });
    ASSERT_TRUE(component.engine()->runFunction(&pausing));
    ASSERT_TRUE(component.engine()->runFunction(&other));
    ASSERT_TRUE(component.trigger());
    ASSERT_TRUE(eventually([&] { return pausing.executions == 1; }));
    component.exception();
    ASSERT_TRUE(component.trigger());
    ASSERT_TRUE(eventually([&] { return other.executions >= 2; }));
    EXPECT_EQ(pausing.executions, 1);
    ASSERT_TRUE(component.recover());  // what was asked of it meanwhile is asked once
    EXPECT_TRUE(eventually([&] { return pausing.executions == 2; }));
    EXPECT_TRUE(component.engine()->removeFunction(&pausing));
    EXPECT_TRUE(component.engine()->removeFunction(&other));
}

TEST(Recover, IsFalseInTheStepThatStopWaitsFor) {
    std::atomic<bool> inside{false};
    std::atomic<int> recovered{-1};
    Probe component;
    component.onError = [&] {
        inside = true;
        if (eventually([&] { return component.getTargetState() == TaskContext::Stopped; }))
            recovered = component.recover();
    };
    ASSERT_TRUE(component.start());
    component.error();
    ASSERT_TRUE(component.trigger());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_TRUE(component.stop());
    EXPECT_EQ(recovered, 0);
    EXPECT_EQ(component.getTaskState(), TaskContext::Stopped);
}

TEST(Recover, IsFalseInUpdateHookAfterStop) {
    std::atomic<int> recovered{-1};
    Probe component;
    component.onUpdate = [&] {
        component.error();
        component.onStop = [&] { recovered = component.recover(); };
        EXPECT_TRUE(component.stop());
        EXPECT_FALSE(component.recover());
    };
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(eventually([&] { return component.updates == 1; }));
    EXPECT_EQ(recovered, 0);
    EXPECT_EQ(component.getTaskState(), TaskContext::Stopped);
}

}  // namespace
