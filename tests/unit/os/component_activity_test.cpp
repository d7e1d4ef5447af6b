// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "file_descriptor_test.hpp"

#include <rtt/InputPort.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/Activities.hpp>

#include <memory>

/** Activities below real components. */
using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Pipe;

namespace {

struct Component : TaskContext {
    std::atomic<int> updates{0};
    std::function<void()> onUpdate;
    explicit Component(const std::string& name) : TaskContext(name) {
        addOperation(
            "inOwnThread", [this] { return getActivity()->isSelf(); }, OwnThread);
    }
    ~Component() override { stop(); }
    void updateHook() override {
        ++updates;
        if (onUpdate) onUpdate();
    }
};

}  // namespace

TEST(SlaveComponent, RunsAStepWhenItsMasterTriggersOrUpdatesIt) {
    Component master("master"), slave("slave");
    ASSERT_TRUE(master.setActivity(new Activity(ORO_SCHED_OTHER, 0, 0.002)));
    ASSERT_TRUE(slave.setActivity(new extras::SlaveActivity(master.getActivity())));
    ASSERT_TRUE(master.addPeer(&slave));
    std::atomic<bool> byTrigger{true}, inMaster{false};
    std::atomic<int> triggers{0}, updates{0};
    slave.onUpdate = [&] { inMaster = master.getActivity()->isSelf(); };
    master.onUpdate = [&] {
        TaskContext* const peer = master.getPeer("slave");
        if (byTrigger && peer->trigger()) ++triggers;
        if (!byTrigger && peer->update()) ++updates;
    };
    ASSERT_TRUE(slave.start());
    EXPECT_EQ(slave.updates, 0);  // only the master makes it run
    ASSERT_TRUE(master.start());
    EXPECT_TRUE(eventually([&] { return slave.updates >= 3; }));
    EXPECT_TRUE(inMaster);
    EXPECT_GT(triggers, 0);
    EXPECT_EQ(updates, 0);
    byTrigger = false;
    EXPECT_TRUE(eventually([&] { return updates >= 3; }));
    EXPECT_TRUE(eventually([&] { return master.stop(); }));
    EXPECT_EQ(slave.updates, triggers + updates);
    EXPECT_TRUE(slave.stop());
}

TEST(SlaveComponent, OutlivesItsMasterComponent) {
    auto master = std::make_unique<Component>("master");
    Component slave("slave");
    ASSERT_TRUE(slave.setActivity(new extras::SlaveActivity(master->getActivity())));
    ASSERT_TRUE(slave.start());
    master.reset();
    const int updates = slave.updates;
    EXPECT_FALSE(slave.trigger());
    EXPECT_TRUE(slave.update());
    EXPECT_EQ(slave.updates, updates + 1);
    EXPECT_TRUE(slave.isActive());
    EXPECT_TRUE(slave.stop());
    EXPECT_TRUE(slave.setActivity(new extras::SequentialActivity));
}

TEST(SlaveComponent, MasterMayGetAnotherActivity) {
    Component master("master"), slave("slave");
    ASSERT_TRUE(slave.setActivity(new extras::SlaveActivity(master.getActivity())));
    ASSERT_TRUE(master.setActivity(new extras::SequentialActivity));
    EXPECT_FALSE(slave.trigger());
    EXPECT_TRUE(slave.getActivity()->isActive());
    ASSERT_TRUE(slave.setActivity(new extras::SlaveActivity(master.getActivity())));
    EXPECT_TRUE(slave.isActive());
}

TEST(FileDescriptorComponent, IsUpdatedByInputTriggersPortsAndCalls) {
    Pipe pipe;
    Component c("io"), caller("caller");
    auto* const io = new extras::FileDescriptorActivity(ORO_SCHED_OTHER, 0);
    ASSERT_TRUE(c.setActivity(io));
    InputPort<int> in("in");
    OutputPort<int> out("out");
    c.addEventPort(in);
    ASSERT_TRUE(out.connectTo(&in, ConnPolicy::buffer(10)));
    std::atomic<int> bytes{0}, samples{0};
    c.onUpdate = [&] {
        if (io->isUpdated(pipe.read))
            while (pipe.take()) ++bytes;
        int sample = 0;
        while (in.read(sample) == NewData) ++samples;
    };
    ASSERT_TRUE(c.start());
    EXPECT_TRUE(eventually([&] { return c.updates == 1; }));  // as every component without a period
    io->watch(pipe.read);
    for (int i = 1; i <= 5; ++i) {
        ASSERT_TRUE(pipe.put());
        EXPECT_TRUE(eventually([&] { return bytes == i; }));
        const int updates = c.updates;
        EXPECT_TRUE(c.trigger());
        EXPECT_TRUE(eventually([&] { return c.updates > updates; }));
        out.write(i);
        EXPECT_TRUE(eventually([&] { return samples == i; }));
        OperationCaller<bool()> call(c.getOperation("inOwnThread"), caller.engine());
        EXPECT_TRUE(call());
    }
    EXPECT_TRUE(c.stop());
    const int updates = c.updates;
    ASSERT_TRUE(pipe.put());
    usleep(5000);
    EXPECT_EQ(c.updates, updates);
}

TEST(SimulatedComponent, IsUpdatedOncePerStepAndByUpdate) {
    Component c("simulated");
    ASSERT_TRUE(c.setActivity(new extras::SimulationActivity(0.001)));
    ASSERT_TRUE(c.start());
    EXPECT_EQ(c.updates, 0);
    EXPECT_TRUE(extras::SimulationThread::Instance()->run(10));
    EXPECT_EQ(c.updates, 10);
    EXPECT_TRUE(c.update());
    EXPECT_EQ(c.updates, 11);
    EXPECT_TRUE(c.stop());
    EXPECT_TRUE(extras::SimulationThread::Instance()->run(10));
    EXPECT_EQ(c.updates, 11);
}

TEST(PeriodicComponent, IsUpdatedWithItsSharedThread) {
    Component a("a"), b("b");
    ASSERT_TRUE(a.setActivity(new extras::PeriodicActivity(ORO_SCHED_OTHER, 0, 0.002)));
    ASSERT_TRUE(b.setActivity(new extras::PeriodicActivity(ORO_SCHED_OTHER, 0, 0.002)));
    EXPECT_EQ(a.getActivity()->thread(), b.getActivity()->thread());
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(b.start());
    EXPECT_TRUE(eventually([&] { return a.updates >= 3 && b.updates >= 3; }));
    OperationCaller<bool()> call(a.getOperation("inOwnThread"), b.engine());
    EXPECT_TRUE(call());
    EXPECT_FALSE(a.trigger());
    EXPECT_TRUE(a.stop());
    EXPECT_TRUE(b.stop());
}
