// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/threadless_activity.hpp>

void RTT::os::detail::log(LogLevel, const char*, std::string_view) {}

namespace {

using model::require;
using model::Trial;
using RTT::extras::SequentialActivity;

/** Its messages are only counted. */
struct Runner : RTT::base::RunnableInterface {
    std::atomic<int> queued{0};
    model::Plain<int> done{0};  // two executions at the same time would be a data race
    Runner() { model::preparePresence(); }
    bool initialize() override { return true; }
    void step() override {}
    void finalize() override { done = done + 100; }
    void work(WorkReason) override { done = queued.load(std::memory_order_acquire); }
    bool hasWork() override { return queued.load(std::memory_order_acquire) > done; }
};

template <int triggers>
void triggering(Trial& trial) {
    Runner runner;
    SequentialActivity activity(&runner);
    require(activity.start(), "not started");
    for (int i = 0; i < triggers; ++i)
        trial.thread([&] {
            runner.queued.fetch_add(1, std::memory_order_release);
            require(activity.trigger(), "refused");
        });
    trial.go();
    require(runner.done == triggers, "a message was forgotten");
}

void stopping(Trial& trial) {
    Runner runner;
    SequentialActivity activity(&runner);
    require(activity.start(), "not started");
    trial.thread([&] {
        runner.queued.fetch_add(1, std::memory_order_release);
        activity.trigger();
    });
    trial.thread([&] { require(activity.stop(), "not stopped"); });
    trial.go();
    require(runner.done >= 100, "executed after stop()");
}

/** One thread makes a call directly, in the stead of who executes; another one triggers. */
void callingDirectly(Trial& trial) {
    Runner runner;
    SequentialActivity activity(&runner);
    require(activity.start(), "not started");
    trial.thread([&] {
        if (activity.beginInStead() != SequentialActivity::Direct::Entered) return;
        runner.done = runner.done + 0;
        activity.endDirect();
    });
    trial.thread([&] {
        runner.queued.fetch_add(1, std::memory_order_release);
        require(activity.trigger(), "refused");
    });
    trial.go();
    require(runner.done == 1, "a message was forgotten");
}

TEST(SequentialActivity, a_direct_call_while_it_is_triggered) { EXPECT_TRUE(model::holds(callingDirectly)); }
TEST(SequentialActivity, two_triggers) { EXPECT_TRUE(model::holds(triggering<2>)); }
TEST(SequentialActivity, three_triggers) { EXPECT_TRUE(model::holds(triggering<3>, {0})); }
TEST(SequentialActivity, stop_waits_for_the_execution) { EXPECT_TRUE(model::holds(stopping)); }

TEST(SequentialActivity, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("sequential_leaves_too_early", triggering<2>));
    EXPECT_TRUE(model::catches("sequential_relaxed_trigger", triggering<2>));
    EXPECT_TRUE(model::catches("sequential_not_woken", stopping));
    EXPECT_TRUE(model::catches("sequential_stop_does_not_wait", stopping));
    EXPECT_TRUE(model::catches("sequential_direct_beside_execution", callingDirectly));
    EXPECT_TRUE(model::catches("sequential_leaves_too_early", callingDirectly));
}

}  // namespace
