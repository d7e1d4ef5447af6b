// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// start() and stop() of os::Thread, whose thread is one of the checker's.
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <model/checked_thread.hpp>

namespace {

using model::require;
using model::Trial;

struct Worker : RTT::os::Thread {
    Worker() : Thread(ORO_SCHED_OTHER, 0, 0.0, 0, "worker") {}
    ~Worker() override { terminate(); }
    bool initialize() override {
        data = 1;
        return true;
    }
    void loop() override {
        require(data == 1, "executed before initialize() or after finalize()");
        loops.fetch_add(1);
    }
    bool breakLoop() override { return true; }
    void finalize() override { data = 2; }
    /** What its thread does; started by the trial. */
    void execute() {
        state_->task.pid = RTT::os::detail::currentTid();
        run();
    }
    void end() {
        state_->exit = true;
        wake(kExitReason);
    }
    model::Plain<int> data{0};
    std::atomic<int> loops{0};
};

/** Started and stopped at once: loop() is executed once or not at all, and never afterwards. */
void startAndStop(Trial& trial) {
    Worker worker;
    trial.thread([&] { worker.execute(); });
    trial.thread([&] {
        require(worker.start(), "not started");
        require(worker.stop(), "not stopped");
        worker.end();
    });
    trial.go();
    require(worker.loops <= 1, "executed twice");
}

/** A start is not lost: loop() is executed. */
void started(Trial& trial) {
    Worker worker;
    trial.thread([&] { worker.execute(); });
    trial.thread([&] {
        require(worker.start(), "not started");
        while (worker.loops.load() == 0) model::yield();
        require(worker.stop(), "not stopped");
        worker.end();
    });
    trial.go();
}

/** loop() blocks until it is told to return: stop() tells it, or it does not begin. */
void stoppedInLoop(Trial& trial) {
    struct Blocking : Worker {
        void loop() override {
            while (!broken.load()) model::yield();
        }
        bool breakLoop() override {
            broken.store(true);
            return true;
        }
        std::atomic<bool> broken{false};
    } worker;
    require(worker.start(), "not started");
    trial.thread([&] { worker.execute(); });
    trial.thread([&] {
        require(worker.stop(), "not stopped");
        worker.end();
    });
    trial.go();
}

/** Of two that stop at the same time, one does. */
void twoStops(Trial& trial) {
    Worker worker;
    std::atomic<int> stops{0};
    require(worker.start(), "not started");
    trial.thread([&] { worker.execute(); });
    trial.thread([&] { stops.fetch_add(worker.stop()); });
    trial.thread([&] {
        stops.fetch_add(worker.stop());
        worker.end();
    });
    trial.go();
    require(stops == 1 && worker.data == 2, "not stopped once");
}

TEST(Thread, started_and_stopped_at_once) { EXPECT_TRUE(model::holds(startAndStop)); }
TEST(Thread, a_start_is_not_lost) { EXPECT_TRUE(model::holds(started)); }
TEST(Thread, stopped_in_a_loop_that_blocks) { EXPECT_TRUE(model::holds(stoppedInLoop)); }
TEST(Thread, stopped_by_two) { EXPECT_TRUE(model::holds(twoStops, {0})); }

TEST(Thread, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("thread_start_woken_first", started));
    EXPECT_TRUE(model::catches("thread_end_not_told", startAndStop));
    EXPECT_TRUE(model::catches("thread_stop_does_not_wait", startAndStop));
    EXPECT_TRUE(model::catches("thread_runs_after_stop", stoppedInLoop));
}

}  // namespace
