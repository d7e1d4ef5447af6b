// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/threadless_activity.hpp>

#include <rtt/extras/SlaveActivity.cpp>

void RTT::os::detail::log(LogLevel, const char*, std::string_view) {}
bool RTT::extras::SlaveActivity::awaitsTurn() const { return false; }

namespace {

using model::require;
using model::Trial;
using RTT::base::DisposableInterface;
using RTT::extras::SequentialActivity;
using RTT::extras::SlaveActivity;

/** Of the slave: sees what others have queued. */
struct Runner : RTT::base::RunnableInterface {
    std::atomic<int> queued{0};
    model::Plain<int> seen{0};  // two executions at the same time would be a data race
    bool initialize() override { return true; }
    void step() override {}
    void finalize() override { seen = seen + 100; }
    void work(WorkReason) override { seen = queued.load(std::memory_order_relaxed); }
};

/** Of the master: keeps the one message of its slave. */
struct MasterRunner : RTT::base::RunnableInterface {
    std::atomic<DisposableInterface*> message{nullptr};
    bool initialize() override { return true; }
    void step() override {}
    void finalize() override {}
    bool process(DisposableInterface* m) override {
        require(message.exchange(m, std::memory_order_acq_rel) == nullptr, "queued twice");
        return true;
    }
    void executeQueued() {
        if (DisposableInterface* const m = message.exchange(nullptr, std::memory_order_acq_rel)) m->executeAndDispose();
    }
};

constexpr int kFirstThread = 2, kSecondThread = 3;  // Linux ids; the scenario itself has 1

struct Prepared {
    Prepared() { model::preparePresence(); }
};

struct World : Prepared {
    MasterRunner masterRunner;
    SequentialActivity master{&masterRunner};
    Runner runner;
    SlaveActivity* slave = new SlaveActivity(&master, &runner);
    World() { require(master.start() && slave->start(), "not started"); }
    ~World() { delete slave; }
    void trigger(int value) {
        runner.queued.store(value, std::memory_order_relaxed);
        require(slave->trigger(), "refused");
    }
};

/** The message is queued at most once, and the slave sees what came before the last trigger. */
void triggering(Trial& trial) {
    World world;
    world.slave->owner_.store(kSecondThread);
    trial.thread([&] {
        world.trigger(1);
        world.trigger(2);
    });
    trial.thread([&] {
        world.masterRunner.executeQueued();
        world.masterRunner.executeQueued();
    });
    trial.go();
    world.masterRunner.executeQueued();
    require(world.runner.seen == 2, "a trigger was forgotten");
}

/** The trigger comes while another thread executes the slave. */
void triggeredWhileExecuting(Trial& trial) {
    World world;
    world.trigger(1);
    world.slave->owner_.store(kFirstThread);
    trial.thread([&] { world.slave->execute(); });
    trial.thread([&] {
        world.runner.queued.store(2, std::memory_order_relaxed);
        world.masterRunner.executeQueued();
    });
    trial.go();
    require(world.runner.seen == 2, "a trigger was forgotten");
}

/** The slave is stopped and destroyed while the master executes its trigger. */
void destroying(Trial& trial) {
    World world;
    world.trigger(1);
    world.slave->owner_.store(kSecondThread);
    trial.thread([&] {
        delete world.slave;
        world.slave = nullptr;
    });
    trial.thread([&] { world.masterRunner.executeQueued(); });
    trial.go();
    require(world.runner.seen >= 100, "executed after it was destroyed");
}

/** One thread makes a call directly, because it stands for the thread that updates the slave; another one updates it. */
void callingDirectly(Trial& trial) {
    model::preparePresence();
    Runner runner;
    SlaveActivity slave(&runner);
    require(slave.start(), "not started");
    trial.thread([&] {
        slave.updater_.store(RTT::os::detail::currentTid());
        if (slave.beginDirect() != SlaveActivity::Direct::Entered) return;
        runner.seen = runner.seen + 1;
        slave.endDirect();
    });
    trial.thread([&] { slave.execute(); });
    trial.go();
}

/** A thread that has executed it before, and need not ask others, and one that comes the first time: not both at the same time, but
    one of the two always does. */
void executedByTwo(Trial& trial) {
    model::preparePresence();
    Runner runner;
    SlaveActivity slave(&runner);
    require(slave.start(), "not started");
    bool first = false, second = false;
    slave.owner_.store(kFirstThread);
    trial.thread([&] {
        require(RTT::os::detail::currentTid() == kFirstThread, "another thread");
        first = slave.execute();
    });
    trial.thread([&] { second = slave.execute(); });
    trial.go();
    require(first || second, "nobody has executed it");
}

TEST(SlaveActivity, executed_by_two_threads) { EXPECT_TRUE(model::holds(executedByTwo)); }
TEST(SlaveActivity, a_direct_call_while_it_is_executed) { EXPECT_TRUE(model::holds(callingDirectly)); }
TEST(SlaveActivity, two_triggers) { EXPECT_TRUE(model::holds(triggering)); }
TEST(SlaveActivity, a_trigger_while_it_is_executed) { EXPECT_TRUE(model::holds(triggeredWhileExecuting, {0})); }
TEST(SlaveActivity, destroyed_while_its_trigger_is_executed) { EXPECT_TRUE(model::holds(destroying)); }

TEST(SlaveActivity, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("slave_relaxed_claim", triggering));
    EXPECT_TRUE(model::catches("slave_unqueued_late", triggering));
    EXPECT_TRUE(model::catches("slave_trigger_not_served", triggeredWhileExecuting));
    EXPECT_TRUE(model::catches("slave_two_execute", triggeredWhileExecuting));
    EXPECT_TRUE(model::catches("slave_two_execute", callingDirectly));
    EXPECT_TRUE(model::catches("slave_two_execute", executedByTwo));
    EXPECT_TRUE(model::catches("slave_owner_not_asked_again", executedByTwo));
    EXPECT_TRUE(model::catches("slave_owner_stays", executedByTwo));
}

}  // namespace
