// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components that nobody executes just now, and who stands for the thread that would: the main thread, or any one that takes a
// function out.
#include "os_test.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/Activities.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <memory>
#include <thread>
#include <vector>

using namespace RTT;
using extras::SimulationThread;
using oroforge::test::eventually;

namespace {

struct Forever : base::ExecutableInterface {
    bool execute() override { return ++executions != 0; }
    std::atomic<int> executions{0};
};

/** Counts threads that are inside at the same time. */
struct Server : TaskContext {
    std::atomic<int> inside{0}, together{0}, updates{0};
    Server() : TaskContext("server") { addOperation("twice", &Server::twice, this, OwnThread); }
    ~Server() override {
        stop();
        getActivity()->stop();
    }
    int twice(int n) {
        visit();
        return 2 * n;
    }
    void updateHook() override {
        visit();
        ++updates;
    }
    void visit() {
        if (++inside != 1) ++together;
        --inside;
    }
};

struct StandInBase {
    std::unique_ptr<TaskContext> master = std::make_unique<TaskContext>("master");
    extras::TimerThreadPtr timer;
    Server server;
    ~StandInBase() { SimulationThread::Release(); }

    void take(base::ActivityInterface* activity) {
        ASSERT_TRUE(server.setActivity(activity));
        ASSERT_TRUE(server.isActive());
    }
    void inAnotherThread(const std::function<void()>& action) { std::thread(action).join(); }
    void prepare(const std::string& kind) {
        const auto isOneOf = [&](const std::string& of) { return kind.compare(0, of.size(), of) == 0; };
        if (isOneOf("simulation")) take(new extras::SimulationActivity(0.001));
        if (kind == "simulation_that_ran") inAnotherThread([] { SimulationThread::Instance()->run(2); });
        if (isOneOf("sequential")) take(new extras::SequentialActivity);
        if (kind == "slave" || kind == "slave_left" || kind == "slave_stopped") take(new extras::SlaveActivity);
        if (kind == "slave_left") inAnotherThread([this] { EXPECT_TRUE(server.update()); });
        if (kind == "slave_orphan" || kind == "slave_of_a_stopped_master")
            take(new extras::SlaveActivity(master->getActivity()));
        if (kind == "slave_orphan") master.reset();
        if (kind == "slave_of_a_stopped_master") {
            ASSERT_TRUE(eventually([&] { return master->getActivity()->stop(); }));
        }
        if (kind == "periodic_of_a_stopped_thread") {
            timer.reset(new extras::TimerThread(ORO_SCHED_OTHER, 0, "timer", 0.001));
            take(new extras::PeriodicActivity(timer));
            ASSERT_TRUE(eventually([&] { return timer->stop(); }));
        }
        if (kind == "simulation_stopped" || kind == "sequential_stopped" || kind == "slave_stopped") {
            ASSERT_TRUE(server.getActivity()->stop());
        }
    }
};

std::string nameOf(const testing::TestParamInfo<const char*>& info) { return info.param; }

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

struct AnybodyTakesOut : testing::TestWithParam<const char*>, StandInBase {
    void SetUp() override { prepare(GetParam()); }
};

TEST_P(AnybodyTakesOut, AFunctionOfAComponentThatNobodyExecutes) {
    Forever first, second;
    ASSERT_TRUE(server.engine()->runFunction(&first));
    inAnotherThread([&] {
        EXPECT_TRUE(server.engine()->removeFunction(&first));
        EXPECT_FALSE(first.isLoaded());
        ASSERT_TRUE(server.engine()->runFunction(&second));
    });
    EXPECT_TRUE(server.engine()->removeFunction(&second));
    EXPECT_FALSE(second.isLoaded());
}
INSTANTIATE_TEST_SUITE_P(Kinds, AnybodyTakesOut,
                         testing::Values("simulation", "simulation_stopped", "simulation_that_ran", "sequential",
                                         "sequential_stopped", "slave", "slave_stopped", "slave_left", "slave_orphan",
                                         "slave_of_a_stopped_master", "periodic_of_a_stopped_thread"),
                         nameOf);

/** A thread that executes the server until leave(). */
class Updater {
public:
    explicit Updater(StandInBase& base) {
        waiting_.action = [this] {
            inside_ = true;
            EXPECT_TRUE(eventually([this] { return leave_.load(); }));
        };
        EXPECT_TRUE(base.server.engine()->runFunction(&waiting_));
        thread_ = std::thread([&base] { EXPECT_TRUE(base.server.update()); });
        EXPECT_TRUE(eventually([this] { return inside_.load(); }));
    }
    ~Updater() {
        leave_ = true;
        thread_.join();
    }
    void leave() { leave_ = true; }

private:
    struct Waiting : base::ExecutableInterface {
        std::function<void()> action;
        bool execute() override { return action(), false; }
    } waiting_;
    std::atomic<bool> inside_{false}, leave_{false};
    std::thread thread_;
};

// The one who executed it last is inside when the removal is asked for, and never comes again.
TEST(AnybodyTakesOut, AFunctionThoughTheOneWhoExecutesLeavesMeanwhile) {
    StandInBase base;
    base.take(new extras::SlaveActivity);
    Forever function;
    ASSERT_TRUE(base.server.engine()->runFunction(&function));
    Updater updater(base);
    std::thread releaser([&] {
        usleep(5000);
        updater.leave();
    });
    EXPECT_TRUE(base.server.engine()->removeFunction(&function));
    releaser.join();
    EXPECT_FALSE(function.isLoaded());
}

TEST(AnybodyTakesOut, AFunctionThoughTheQueueIsFull) {
    StandInBase base;
    base.take(new extras::SlaveActivity);
    OperationCaller<int(int)> twice(base.server.getOperation("twice"), internal::GlobalEngine::Instance());
    Forever function;
    ASSERT_TRUE(base.server.engine()->runFunction(&function));
    Updater updater(base);
    std::vector<SendHandle<int(int)>> sent;
    while ((sent.push_back(twice.send(1)), sent.back().ready()) && sent.size() < 1000) {}
    std::thread releaser([&] {
        usleep(5000);
        updater.leave();
    });
    EXPECT_TRUE(base.server.engine()->removeFunction(&function));
    releaser.join();
    EXPECT_FALSE(function.isLoaded());
}

// Each leaves a removal in the queue that was withdrawn.
TEST(AnybodyTakesOut, MoreFunctionsThanTheQueueTakesWhileOthersComeAndGo) {
    StandInBase base;
    base.take(new extras::SlaveActivity);
    for (int i = 0; i != 3; ++i) {
        Forever function;
        ASSERT_TRUE(base.server.engine()->runFunction(&function));
        Updater updater(base);
        std::thread releaser([&] {
            usleep(5000);
            updater.leave();
        });
        EXPECT_TRUE(base.server.engine()->removeFunction(&function));
        releaser.join();
    }
    Forever function;
    for (int i = 0; i != 300; ++i) {
        ASSERT_TRUE(base.server.engine()->runFunction(&function)) << i;
        ASSERT_TRUE(base.server.engine()->removeFunction(&function)) << i;
    }
}

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
    std::thread updater([&] { EXPECT_TRUE(base.server.update()); });
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    std::thread releaser([&] {
        usleep(5000);
        leave = true;
    });
    EXPECT_EQ(twice(3), 6);  // by the updater, or by this thread afterwards
    updater.join();
    releaser.join();
}

TEST(StandIn, OfASimulationIsNotOverlappedByItsSteps) {
    StandInBase base;
    base.take(new extras::SimulationActivity(0.001));
    ASSERT_TRUE(base.server.start());
    OperationCaller<int(int)> twice(base.server.getOperation("twice"), base.server.engine());
    std::atomic<bool> end{false};
    std::thread simulation([&] {
        while (!end) SimulationThread::Instance()->run(1);
    });
    std::thread remover([&] {
        Forever function;
        while (!end)
            if (base.server.engine()->runFunction(&function)) {
                EXPECT_TRUE(base.server.engine()->removeFunction(&function));
            }
    });
    for (int i = 0; i != 2000; ++i) ASSERT_EQ(twice(i), 2 * i);
    EXPECT_TRUE(eventually([&] { return base.server.updates >= 10; }));
    end = true;
    simulation.join();
    remover.join();
    EXPECT_EQ(base.server.together, 0);
}

TEST(StandIn, OfASequentialActivityIsNotOverlappedByTriggers) {
    StandInBase base;
    base.take(new extras::SequentialActivity);
    ASSERT_TRUE(base.server.start());
    OperationCaller<int(int)> twice(base.server.getOperation("twice"), base.server.engine());
    std::atomic<bool> end{false};
    std::thread restarts([&] {
        while (!end)
            if (base.server.getActivity()->stop()) base.server.getActivity()->start();
    });
    std::thread triggers([&] {
        while (!end) base.server.trigger();
    });
    for (int i = 0; i != 2000; ++i) ASSERT_EQ(twice(i), 2 * i);
    end = true;
    restarts.join();
    triggers.join();
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
