// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions that any thread takes out of a component that no thread executes just now.
#include "stand_in_base.hpp"

#include <vector>

using namespace stand_in;

namespace {

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
    while ((sent.push_back(twice.send(1)), sent.back().ready()) && sent.size() < 1000) {
    }
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

// The activity has a thread that is not active: each remover does it itself.
TEST(AnybodyTakesOut, FunctionsOfAnInactiveComponentAtTheSameTime) {
    StandInBase base;
    ASSERT_TRUE(base.server.getActivity()->stop());
    const auto comeAndGo = [&] {
        Forever function;
        for (int i = 0; i != 40; ++i)
            if (base.server.engine()->runFunction(&function)) {
                EXPECT_TRUE(base.server.engine()->removeFunction(&function));
            }
    };
    std::thread other(comeAndGo);
    comeAndGo();
    other.join();
}

}  // namespace
