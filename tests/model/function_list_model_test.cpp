// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Idle functions that other threads wake while the engine executes.
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/base/DisposableInterface.cpp>
#include <rtt/internal/engine/function_list.cpp>

namespace {

using model::require;
using model::Trial;
using RTT::internal::FunctionList;

/** What it is given is ordered by wake() alone. */
struct Worker : RTT::base::ExecutableInterface {
    bool execute() override {
        if (work.exchange(false, std::memory_order_relaxed)) ++done;
        return true;
    }
    bool isIdle() const override { return !work.load(std::memory_order_relaxed); }
    void give() {
        work.store(true, std::memory_order_relaxed);
        wake();
    }
    std::atomic<bool> work{false};
    int done = 0;
};

/** As the engine does it. */
void step(FunctionList& list) {
    FunctionList::Round round = list.begin();
    list.takeWoken();
    while (RTT::base::ExecutableInterface* const function = list.next(round)) {
        function->execute();
        list.rest(round);
        list.takeWoken();
    }
}

/** One is woken in the middle of steps: the step after that executes it at the latest. */
void woken(Trial& trial) {
    FunctionList list;
    Worker worker, other;
    list.add(&other);
    list.add(&worker);
    step(list);
    trial.thread([&] { worker.give(); });
    trial.thread([&] {
        step(list);
        step(list);
    });
    trial.go();
    step(list);
    require(worker.done == 1, "a function that was woken is not executed");
    require(other.done == 0, "the wrong one has worked");
}

/** Somebody wakes one while the engine looks for another one that was woken. */
void wokenOneAfterTheOther(Trial& trial) {
    FunctionList list;
    Worker first, second;
    list.add(&first);
    list.add(&second);
    step(list);
    for (Worker* const worker : {&first, &second}) trial.thread([worker] { worker->give(); });
    trial.thread([&] { step(list); });
    trial.go();
    step(list);
    require(first.done == 1 && second.done == 1, "a function that was woken is not executed");
}

/** It finds out that it is idle just when it gets something to do, by two threads. */
void wokenWhileItFallsAsleep(Trial& trial) {
    FunctionList list;
    Worker worker;
    list.add(&worker);
    for (int i = 0; i < 2; ++i) trial.thread([&] { worker.give(); });
    trial.thread([&] { step(list); });
    trial.go();
    step(list);
    require(worker.done == 1 || worker.done == 2, "a function that was woken is not executed");
    require(!worker.work.load(), "what was given last is left");
}

TEST(FunctionList, woken_in_the_middle_of_steps) { EXPECT_TRUE(model::holds(woken)); }
TEST(FunctionList, woken_one_after_the_other) { EXPECT_TRUE(model::holds(wokenOneAfterTheOther)); }
TEST(FunctionList, woken_while_it_falls_asleep) { EXPECT_TRUE(model::holds(wokenWhileItFallsAsleep)); }

TEST(FunctionList, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("functions_relaxed_wake", woken));
    EXPECT_TRUE(model::catches("functions_relaxed_take", woken));
    EXPECT_TRUE(model::catches("functions_not_woken", woken));
    EXPECT_TRUE(model::catches("functions_seen_too_late", wokenOneAfterTheOther));
    EXPECT_TRUE(model::catches("functions_not_woken", wokenWhileItFallsAsleep));
}

}  // namespace
