// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components in simulated time: messages, events, chains.
#include "clock_test.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <memory>

namespace {

using namespace oroforge::test;
using RTT::OperationCaller;

struct Worker : RTT::TaskContext {
    explicit Worker(const std::string& name, double period = 0.01) : TaskContext(name) {
        setPeriod(period);
        EXPECT_TRUE(rtt_rosclock::set_sim_clock_activity(this));
        addOperation("twice", &Worker::twice, this, RTT::OwnThread);
        addEventPort("in", in, [this](RTT::base::PortInterface*) { take(); });
        addPort("out", out);
    }
    ~Worker() override { stopForGood(); }
    int twice(int x) {
        if (onCall) onCall();
        return 2 * x;
    }
    void updateHook() override {
        ++updates;
        if (onUpdate) onUpdate();
    }
    void take() {
        int x = 0;
        while (in.read(x) == RTT::NewData) {
            log.push_back(x);
            ++taken;
        }
    }

    RTT::InputPort<int> in;
    RTT::OutputPort<int> out;
    std::function<void()> onUpdate, onCall;
    std::vector<nsecs> log;
    std::atomic<int> updates{0}, taken{0};
};

OperationCaller<int(int)> callerOf(RTT::TaskContext& to) {
    return {to.getOperation("twice"), RTT::internal::GlobalEngine::Instance()};
}

TEST_F(ManualClock, OperationsAndEventsAreServedWhileTheTimeStandsStill) {
    Worker w("w");
    ASSERT_TRUE(w.start() && update(10 * kMs));
    EXPECT_EQ(callerOf(w)(21), 42);
    RTT::OutputPort<int> writer("writer");
    ASSERT_TRUE(writer.connectTo(&w.in));
    writer.write(7);
    EXPECT_TRUE(eventually([&] { return w.taken == 1; }));
    EXPECT_EQ(w.updates, 1);
    ASSERT_TRUE(w.stop());
    EXPECT_EQ(callerOf(w)(4), 8);
}

TEST(Served, AlsoBeforeSimulatedTimeIsEnabled) {
    Worker w("w");
    ASSERT_TRUE(w.start());
    EXPECT_EQ(callerOf(w)(21), 42);
    EXPECT_EQ(w.updates, 0);
}

// More than the queue of the thread holds.
TEST_F(ManualClock, ManyComponentsAreServedAtOnce) {
    std::vector<std::unique_ptr<Worker>> all;
    RTT::OutputPort<int> writer("writer");
    for (int i = 0; i != 300; ++i) {
        all.push_back(std::make_unique<Worker>("w" + std::to_string(i)));
        ASSERT_TRUE(writer.connectTo(&all.back()->in));
        ASSERT_TRUE(all.back()->start());
    }
    writer.write(1);
    for (const auto& one : all) EXPECT_TRUE(eventually([&] { return one->taken == 1; }));
    all[0]->onUpdate = [&] { writer.write(2); };
    ASSERT_TRUE(update(10 * kMs));
    for (const auto& one : all) EXPECT_EQ(one->taken, 2) << one->getName();
}

TEST_F(ManualClock, AComponentThatMovesTheTimeIsServedMeanwhile) {
    Worker w("w");
    RTT::TaskContext source("source");
    int result = 0;
    source.addOperation(
        "move", [] { return update(10 * kMs); }, RTT::OwnThread);
    source.addOperation(
        "twice", [](int x) { return 2 * x; }, RTT::OwnThread);
    OperationCaller<int(int)> ask(source.getOperation("twice"), w.engine());
    w.onUpdate = [&] { result = ask(3); };
    ASSERT_TRUE(w.start() && source.start());
    OperationCaller<bool()> move(source.getOperation("move"), RTT::internal::GlobalEngine::Instance());
    EXPECT_TRUE(move());
    EXPECT_EQ(result, 6);
    source.stopForGood();
}

// The thread of the simulation waits for a component that calls another one in simulated time.
TEST_F(ManualClock, AComponentIsServedWhileAnotherOneWaitsInAStep) {
    Worker a("a"), b("b");
    RTT::TaskContext between("between");
    OperationCaller<int(int)> askB(b.getOperation("twice"), between.engine());
    between.addOperation(
        "twice", [&](int x) { return askB(x) + 1; }, RTT::OwnThread);
    OperationCaller<int(int)> ask(between.getOperation("twice"), a.engine());
    int result = 0;
    a.onUpdate = [&] { result = ask(3); };
    ASSERT_TRUE(a.start() && b.start() && between.start());
    ASSERT_TRUE(update(10 * kMs));
    EXPECT_EQ(result, 7);
    between.stopForGood();
}

TEST_F(ManualClock, AComponentIsDestroyedInItsOwnStep) {
    Worker other("other");
    auto w = std::make_unique<Worker>("w");
    w->onUpdate = [&] {
        const auto keep = std::move(w->onUpdate);  // this function
        w.reset();
    };
    ASSERT_TRUE(w->start() && other.start());
    ASSERT_TRUE(update(10 * kMs));
    EXPECT_FALSE(w);
    ASSERT_TRUE(update(20 * kMs));
    EXPECT_EQ(other.updates, 2);
}

/// A chain: a source of 10 ms, an event port behind it, and a sink of 25 ms that calls the source.
std::vector<nsecs> sequenceOfAChain(nsecs step) {
    std::vector<nsecs> all;
    Worker source("source"), middle("middle", 0), sink("sink", 0.025);
    EXPECT_TRUE(source.out.connectTo(&middle.in));
    EXPECT_TRUE(middle.out.connectTo(&sink.in, RTT::ConnPolicy::buffer(10)));
    OperationCaller<int(int)> ask(source.getOperation("twice"), sink.engine());
    int count = 0;
    source.onUpdate = [&] {
        all.push_back(simulated() + 1);
        source.out.write(++count);
    };
    middle.onUpdate = [&] { middle.out.write(static_cast<int>(middle.log.size())); };
    sink.onUpdate = [&] { all.push_back(simulated() + 2 + ask(static_cast<int>(sink.log.size()))); };
    source.onCall = [&] { all.push_back(3); };
    EXPECT_TRUE(sink.start() && middle.start() && source.start());
    for (nsecs now = step; now <= 1000 * kMs; now += step) EXPECT_TRUE(update(now));
    EXPECT_TRUE(source.stop() && middle.stop() && sink.stop());
    all.insert(all.end(), middle.log.begin(), middle.log.end());
    all.insert(all.end(), sink.log.begin(), sink.log.end());
    return all;
}

TEST_F(ManualClock, AChainGivesTheSameSequenceTwice) {
    const std::vector<nsecs> first = sequenceOfAChain(5 * kMs);
    EXPECT_GT(first.size(), 250u);
    for (int i = 0; i != 5; ++i) {
        ASSERT_TRUE(update(0));
        EXPECT_EQ(sequenceOfAChain(5 * kMs), first);
    }
}

}  // namespace
