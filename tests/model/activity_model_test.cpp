// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Triggers of an Activity that is about to sleep, to start or to stop.
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/checked_presence.hpp>
#include <model/checked_thread.hpp>

#include <rtt/Activity.cpp>
#include <rtt/base/ActivityInterface.cpp>
#include <rtt/base/DisposableInterface.cpp>
#include <rtt/base/RunnableInterface.cpp>
#include <rtt/internal/engine/access_gate.cpp>

namespace {

using model::require;
using model::Trial;
using RTT::Activity;

/** Sees what others have queued. */
struct Runner : RTT::base::RunnableInterface {
    std::atomic<int> queued{0}, seen{0}, timeouts{0};
    Runner() { model::preparePresence(); }
    bool initialize() override { return true; }
    void step() override {}
    void finalize() override {}
    void work(WorkReason reason) override {
        if (reason == TimeOut)
            timeouts.fetch_add(1);
        else
            seen.store(queued.load(std::memory_order_relaxed));
    }
};

struct World {
    Runner runner;
    Activity activity{&runner, "activity"};
    ~World() { activity.terminate(); }
    /** What the thread of the activity does. */
    void execute() {
        activity.state_->task.pid = RTT::os::detail::currentTid();
        static_cast<RTT::os::Thread&>(activity).run();
    }
    void end() {
        activity.state_->running = false;
        activity.state_->exit = true;
        activity.wake(RTT::os::Thread::kExitReason);
    }
};

/** Everything that was queued before a trigger is seen, with one wake-up at most for each time it slept. */
template <int triggers>
void triggering(Trial& trial) {
    World world;
    require(world.activity.start(), "not started");
    trial.thread([&] { world.execute(); });
    trial.thread([&] {
        for (int i = 1; i <= triggers; ++i) {
            world.runner.queued.store(i, std::memory_order_relaxed);
            require(world.activity.trigger(), "refused");
        }
        while (world.runner.seen.load() != triggers) model::yield();
        world.end();
    });
    trial.go();
}

/** A trigger and a timeout: each is served. */
void triggerAndTimeout(Trial& trial) {
    World world;
    require(world.activity.start(), "not started");
    trial.thread([&] { world.execute(); });
    trial.thread([&] {
        require(world.activity.timeout(), "refused");
        world.runner.queued.store(1, std::memory_order_relaxed);
        require(world.activity.trigger(), "refused");
        while (world.runner.seen.load() != 1 || world.runner.timeouts.load() != 1) model::yield();
        world.end();
    });
    trial.go();
}

/** A timeout before the start is executed after it, and so is what was queued before the start. */
void startingLate(Trial& trial) {
    World world;
    trial.thread([&] { world.execute(); });
    trial.thread([&] {
        world.activity.timeout();
        world.runner.queued.store(1, std::memory_order_relaxed);
        require(world.activity.start(), "not started");
        while (world.runner.seen.load() != 1 || world.runner.timeouts.load() != 1) model::yield();
        world.end();
    });
    trial.go();
}

TEST(Activity, a_trigger_is_not_lost) { EXPECT_TRUE(model::holds(triggering<1>)); }
TEST(Activity, two_triggers) { EXPECT_TRUE(model::holds(triggering<2>, {0})); }
TEST(Activity, a_trigger_and_a_timeout) { EXPECT_TRUE(model::holds(triggerAndTimeout, {0})); }
TEST(Activity, a_timeout_before_the_start) { EXPECT_TRUE(model::holds(startingLate, {0})); }

TEST(Activity, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("activity_looks_then_sleeps", triggering<1>));
    EXPECT_TRUE(model::catches("activity_timeout_hides_trigger", triggerAndTimeout));
    EXPECT_TRUE(model::catches("activity_early_timeout_lost", startingLate));
    EXPECT_TRUE(model::catches("activity_start_executes_nothing", startingLate));
}

}  // namespace
