// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A main thread that stands for the thread which would execute a component.
#include "stand_in_base.hpp"

using namespace stand_in;

namespace {

struct MainStandsIn : testing::TestWithParam<const char*>, StandInBase {
    void SetUp() override { prepare(GetParam()); }
};

TEST_P(MainStandsIn, ForACallInTheNameOfTheComponent) {
    OperationCaller<int(int)> twice(server.getOperation("twice"), server.engine());
    EXPECT_TRUE(server.engine()->isSelf());
    EXPECT_EQ(twice(3), 6);
    EXPECT_EQ(twice(4), 8);
}

TEST_P(MainStandsIn, ForACallOfAnotherCaller) {
    OperationCaller<int(int)> twice(server.getOperation("twice"), internal::GlobalEngine::Instance());
    EXPECT_EQ(twice(3), 6);
}

TEST_P(MainStandsIn, ForASentCallThatItCollects) {
    OperationCaller<int(int)> twice(server.getOperation("twice"), server.engine());
    SendHandle<int(int)> handle = twice.send(5);
    int result = 0;
    EXPECT_EQ(handle.collect(result), SendSuccess);
    EXPECT_EQ(result, 10);
}

TEST_P(MainStandsIn, ForAFunctionThatItTakesOut) {
    Forever function;
    ASSERT_TRUE(server.engine()->runFunction(&function));
    EXPECT_TRUE(server.engine()->removeFunction(&function));
    EXPECT_FALSE(function.isLoaded());
    EXPECT_EQ(function.executions, 0);
}

TEST_P(MainStandsIn, ForMoreFunctionsThanTheQueueTakes) {
    Forever kept, function;
    ASSERT_TRUE(server.engine()->runFunction(&kept));
    for (int i = 0; i != 300; ++i) {
        ASSERT_TRUE(server.engine()->runFunction(&function)) << i;
        ASSERT_TRUE(server.engine()->removeFunction(&function)) << i;
    }
    EXPECT_TRUE(kept.isLoaded());
    EXPECT_TRUE(server.engine()->removeFunction(&kept));
}

TEST_P(MainStandsIn, AndNoOtherThreadDoes) {
    inAnotherThread([this] { EXPECT_FALSE(server.engine()->isSelf()); });
}

TEST_P(MainStandsIn, UntilAnotherActivityTakesTheComponentOver) {
    Activity other(ORO_SCHED_OTHER, 0, 0.0, server.engine());
    ASSERT_TRUE(other.start());
    EXPECT_FALSE(server.engine()->isSelf());
    OperationCaller<int(int)> twice(server.getOperation("twice"), internal::GlobalEngine::Instance());
    EXPECT_EQ(twice(3), 6);
    EXPECT_TRUE(other.stop());
}
INSTANTIATE_TEST_SUITE_P(Kinds, MainStandsIn,
                         testing::Values("simulation", "simulation_stopped", "simulation_that_ran",
                                         "sequential_stopped", "slave", "slave_stopped", "slave_left", "slave_orphan"),
                         nameOf);

TEST(MainStandsIn, ForACallThatFoundAnotherThreadInside) {
    StandInBase base;
    base.take(new extras::SimulationActivity(0.001));
    std::atomic<bool> inside{false}, leave{false};
    base.server.addOperation(
        "wait",
        [&] {
            inside = true;
            EXPECT_TRUE(eventually([&] { return leave.load(); }));
        },
        OwnThread);
    OperationCaller<void()> wait(base.server.getOperation("wait"), internal::GlobalEngine::Instance());
    OperationCaller<int(int)> twice(base.server.getOperation("twice"), base.server.engine());
    wait.send();
    Joined updater([&] { EXPECT_TRUE(base.server.update()); });
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    Joined releaser([&] {
        usleep(5000);
        leave = true;
    });
    EXPECT_EQ(twice(3), 6);  // by the updater, or by this thread afterwards
    updater.join();
    releaser.join();
}

TEST(StandIn, OfASimulatedMasterExecutesItsSlaveOnlyWithinAStep) {
    StandInBase base;
    struct Master : TaskContext {
        Master() : TaskContext("simulated") {}
        ~Master() override { stop(); }
        void updateHook() override {
            if (hook) hook();
        }
        std::function<void()> hook;
    } master;
    ASSERT_TRUE(master.setActivity(new extras::SimulationActivity(0.001)));
    base.take(new extras::SlaveActivity(master.getActivity()));
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(base.server.start());
    base.server.trigger();
    EXPECT_EQ(base.server.updates, 0);
    master.hook = [&] { base.server.trigger(); };
    ASSERT_TRUE(master.update());
    EXPECT_EQ(base.server.updates, 1);
    master.hook = [&] {
        EXPECT_TRUE(master.getActivity()->stop());
        base.server.trigger();
    };
    ASSERT_TRUE(master.update());
    EXPECT_EQ(base.server.updates, 2);
    master.hook = nullptr;
    ASSERT_TRUE(base.server.getActivity()->stop());
}

// The thread that updated it goes on with something else.
TEST(StandIn, OfASlaveThatWasStopped) {
    StandInBase base;
    base.take(new extras::SlaveActivity);
    std::atomic<bool> updated{false}, end{false};
    Joined updater([&] {
        EXPECT_TRUE(base.server.update());
        updated = true;
        EXPECT_TRUE(eventually([&] { return end.load(); }));
    });
    EXPECT_TRUE(eventually([&] { return updated.load(); }));
    ASSERT_TRUE(base.server.getActivity()->stop());
    OperationCaller<int(int)> twice(base.server.getOperation("twice"), base.server.engine());
    EXPECT_EQ(twice(3), 6);
    end = true;
    updater.join();
}

TEST(StandIn, OfASimulationIsNotOverlappedByItsSteps) {
    StandInBase base;
    base.take(new extras::SimulationActivity(0.001));
    ASSERT_TRUE(base.server.start());
    OperationCaller<int(int)> twice(base.server.getOperation("twice"), base.server.engine());
    Repeated simulation([] { SimulationThread::Instance()->run(1); });
    Forever function;
    Repeated remover([&] {
        if (base.server.engine()->runFunction(&function)) {
            EXPECT_TRUE(base.server.engine()->removeFunction(&function));
        }
    });
    for (int i = 0; i != 2000; ++i) ASSERT_EQ(twice(i), 2 * i);
    EXPECT_TRUE(eventually([&] { return base.server.updates >= 10; }));
    simulation.finish();
    remover.finish();
    EXPECT_EQ(base.server.together, 0);
}

TEST(StandIn, OfASequentialActivityIsNotOverlappedByTriggers) {
    StandInBase base;
    base.take(new extras::SequentialActivity);
    ASSERT_TRUE(base.server.start());
    OperationCaller<int(int)> twice(base.server.getOperation("twice"), base.server.engine());
    Repeated restarts([&] {
        if (base.server.getActivity()->stop()) base.server.getActivity()->start();
    });
    Repeated triggers([&] { base.server.trigger(); });
    for (int i = 0; i != 2000; ++i) ASSERT_EQ(twice(i), 2 * i);
    restarts.finish();
    triggers.finish();
    EXPECT_EQ(base.server.together, 0);
}

TEST(StandIn, OfASequentialActivityMayStartAndStopIt) {
    StandInBase base;
    base.take(new extras::SequentialActivity);
    ASSERT_TRUE(base.server.getActivity()->stop());
    bool stopped = false, started = false;
    base.server.addOperation(
        "restart",
        [&] {
            started = base.server.getActivity()->start();
            stopped = base.server.getActivity()->stop();
            started = started && base.server.getActivity()->start();
            base.server.trigger();
        },
        OwnThread);
    ASSERT_TRUE(base.server.start());
    ASSERT_EQ(base.server.updates, 0);
    OperationCaller<void()> restart(base.server.getOperation("restart"), base.server.engine());
    restart();
    EXPECT_TRUE(started);
    EXPECT_TRUE(stopped);
    EXPECT_FALSE(base.server.getActivity()->isRunning());
    EXPECT_EQ(base.server.updates, 1);  // what was triggered within comes afterwards
    EXPECT_TRUE(base.server.trigger());
    EXPECT_EQ(base.server.updates, 2);
}

}  // namespace
