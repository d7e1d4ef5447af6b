// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions that have nothing to do, such as stopped programs: steps leave them out until somebody wakes them.
#include "probe.hpp"

#include <memory>
#include <random>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::makeManual;
using oroforge::test::Probe;

namespace {

/** Has something to do after give(), once. */
struct Sleeper : base::ExecutableInterface {
    bool execute() override {
        ++executions;
        if (!busy.exchange(false)) return true;
        ++done;
        if (onWork) onWork();
        return again;
    }
    bool isIdle() const override { return !busy; }
    void give() {
        busy = true;
        wake();
    }
    std::function<void()> onWork;
    std::atomic<bool> busy{false};
    std::atomic<int> executions{0}, done{0};
    bool again = true;
};

TEST(IdleFunctions, AreNotExecutedUntilTheyAreWoken) {
    Sleeper sleeper;
    Probe probe;
    makeManual(probe);
    ASSERT_TRUE(probe.engine()->runFunction(&sleeper));
    for (int i = 0; i != 5; ++i) ASSERT_TRUE(probe.update());
    EXPECT_LE(sleeper.executions, 1) << "it may find out that there is nothing to do";
    const int before = sleeper.executions;
    sleeper.give();
    for (int i = 0; i != 5; ++i) ASSERT_TRUE(probe.update());
    EXPECT_EQ(sleeper.done, 1);
    EXPECT_EQ(sleeper.executions, before + 1);
    EXPECT_TRUE(sleeper.isLoaded());
}

TEST(IdleFunctions, ThatAreWokenWithinAStepKeepTheirTurn) {
    std::string order;
    Sleeper functions[3];
    Probe probe;
    makeManual(probe);
    for (int i = 0; i != 3; ++i) ASSERT_TRUE(probe.engine()->runFunction(&functions[i]));
    for (int i = 0; i != 3; ++i) functions[i].onWork = [&order, i] { order += std::to_string(i); };
    ASSERT_TRUE(probe.update());
    functions[2].give();
    functions[0].give();
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(order, "02") << "in the order in which they were loaded";
    order.clear();
    functions[1].onWork = [&] {
        order += "1";
        functions[0].give();
        functions[2].give();
    };
    functions[1].give();
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(order, "12") << "the first one has had its turn";
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(order, "120");
    functions[1].onWork = [&] { functions[1].give(); };
    functions[1].give();
    for (int i = 0; i != 3; ++i) ASSERT_TRUE(probe.update());
    EXPECT_EQ(functions[1].done, 4) << "one that wakes itself goes on in the next step";
}

TEST(IdleFunctions, AreWokenByMessagesAndHooksOfTheirComponent) {
    Sleeper sleeper;
    Probe probe;
    makeManual(probe);
    probe.addOperation(
        "give", [&] { sleeper.give(); }, OwnThread);
    ASSERT_TRUE(probe.engine()->runFunction(&sleeper) && probe.start() && probe.update());
    OperationCaller<void()> give(probe.getOperation("give"), nullptr);
    auto handle = give.send();
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(sleeper.done, 1) << "in the same step";
    probe.onUpdate = [&] { sleeper.give(); };
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(sleeper.done, 1);
    probe.onUpdate = nullptr;
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(sleeper.done, 2) << "in the next one";
}

TEST(IdleFunctions, AreRemovedLoadedAnewAndDestroyedWhileTheyAreIdle) {
    auto first = std::make_unique<Sleeper>();
    Sleeper second;
    Probe probe;
    makeManual(probe);
    ASSERT_TRUE(probe.engine()->runFunction(first.get()) && probe.engine()->runFunction(&second));
    ASSERT_TRUE(probe.update() && probe.update());
    EXPECT_TRUE(probe.engine()->removeFunction(first.get()));
    EXPECT_FALSE(first->isLoaded());
    first->give();
    first.reset();
    second.give();
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(second.done, 1);
    EXPECT_TRUE(probe.engine()->removeFunction(&second) && probe.engine()->runFunction(&second));
    second.give();
    ASSERT_TRUE(probe.update());
    EXPECT_EQ(second.done, 2);
    second.again = false;
    second.give();
    ASSERT_TRUE(probe.update());
    EXPECT_FALSE(second.isLoaded()) << "it is done";
}

TEST(IdleFunctions, AreUnloadedWithTheirComponent) {
    Sleeper sleeper;
    {
        Probe probe;
        makeManual(probe);
        ASSERT_TRUE(probe.engine()->runFunction(&sleeper) && probe.update() && probe.update());
    }
    EXPECT_FALSE(sleeper.isLoaded());
    sleeper.give();
}

TEST(IdleFunctions, HundredsOfThemAreFoundWhereverTheyStand) {
    std::vector<std::unique_ptr<Sleeper>> all;
    std::vector<std::size_t> order;
    Probe probe;
    makeManual(probe);
    for (std::size_t i = 0; i != 300; ++i) {
        all.push_back(std::make_unique<Sleeper>());
        all.back()->onWork = [&order, i] { order.push_back(i); };
        ASSERT_TRUE(probe.engine()->runFunction(all.back().get()));
        // The mailbox of the engine has room for a hundred of them.
        ASSERT_TRUE(i % 100 != 99 || probe.update());
    }
    std::minstd_rand random(7);
    for (int round = 0; round != 100; ++round) {
        std::vector<std::size_t> given;
        for (std::size_t i = 0; i != all.size(); ++i) {
            if (!all[i] || random() % 7 != 0) continue;
            all[i]->give();
            given.push_back(i);
        }
        order.clear();
        ASSERT_TRUE(probe.update());
        ASSERT_EQ(order, given);
        const std::size_t leaving = random() % all.size();
        if (all[leaving]) {
            EXPECT_TRUE(probe.engine()->removeFunction(all[leaving].get()));
        }
        all[leaving].reset();
    }
}

TEST(IdleFunctions, AreWokenByOtherThreads) {
    Sleeper sleepers[4];
    Probe probe;
    probe.setPeriod(0.0002);
    for (Sleeper& sleeper : sleepers) ASSERT_TRUE(probe.engine()->runFunction(&sleeper));
    std::vector<std::thread> threads;
    for (Sleeper& sleeper : sleepers)
        threads.emplace_back([&sleeper] {
            for (int i = 1; i <= 300; ++i) {
                sleeper.give();
                ASSERT_TRUE(eventually([&] { return sleeper.done == i; })) << i;
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (Sleeper& sleeper : sleepers) EXPECT_TRUE(probe.engine()->removeFunction(&sleeper));
}

}  // namespace
