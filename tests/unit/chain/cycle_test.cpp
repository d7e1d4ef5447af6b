// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What happens in cycles: failures, stopped and deleted members, dividers, budgets, triggers.
#include "chain_fixture.hpp"

#include <rtt/extras/SimulationActivity.hpp>
#include <rtt/extras/SimulationThread.hpp>

namespace {

using namespace chain_test;

class ChainCycle : public Chained {
protected:
    void SetUp() override {
        Chained::SetUp();
        for (const char* name : {"a", "b", "c"}) add(name);
    }
};

TEST_F(ChainCycle, StopAndStartKeepOneRunPerCycle) {
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(chain->start());
        EXPECT_THAT(cycle(), ElementsAre("a", "b", "c"));
        ASSERT_TRUE(chain->stop());
    }
    chain->update();
    EXPECT_EQ(3, (*this)["a"].updates);
}

TEST_F(ChainCycle, AFailingMemberIsLeftOut) {
    LogText log;
    ASSERT_TRUE(chain->start());
    (*this)["a"].getActivity()->stop();
    EXPECT_THAT(cycle(), ElementsAre("b", "c"));
    const auto isLogged = [&] { return log().find("member 'a' failed in 1 cycle:") != std::string::npos; };
    EXPECT_TRUE(within(5, isLogged)) << log();
    for (int i = 0; i < 4; ++i) EXPECT_THAT(cycle(), ElementsAre("b", "c"));
    EXPECT_EQ(5u, statistics("a").failures);
    EXPECT_EQ(5u, statistics("b").times.count);
    chain->stop();
    EXPECT_THAT(log(), HasSubstr("member 'a' failed in 4 cycles: its activity is not active"));
    (*this)["a"].getActivity()->start();
}

TEST_F(ChainCycle, AFailureEndsTheCycle) {
    set(*chain, "on_error", std::string("stop_cycle"));
    ASSERT_TRUE(chain->start());
    (*this)["b"].getActivity()->stop();
    EXPECT_THAT(cycle(), ElementsAre("a"));
    EXPECT_EQ(1u, statistics("c").left_out);
    (*this)["b"].getActivity()->start();
    EXPECT_THAT(cycle(), ElementsAre("a", "b", "c"));
}

TEST_F(ChainCycle, AFailureStopsTheChain) {
    set(*chain, "on_error", std::string("stop"));
    ASSERT_TRUE(chain->start());
    (*this)["b"].getActivity()->stop();
    EXPECT_THAT(cycle(), ElementsAre("a"));
    EXPECT_EQ(OCL::Chain::RunTimeError, chain->getTaskState());
    EXPECT_THAT(cycle(), ElementsAre());
    (*this)["b"].getActivity()->start();
    ASSERT_TRUE(chain->recover());
    EXPECT_THAT(cycle(), ElementsAre("a", "b", "c"));
}

TEST_F(ChainCycle, AnExceptionStopsOnlyTheMember) {
    LogText log;
    (*this)["b"].each = [] { throw std::runtime_error("thrown by the test"); };
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(cycle(), ElementsAre("a", "b", "c"));
    EXPECT_THAT(cycle(), ElementsAre("a", "c"));
    EXPECT_TRUE((*this)["b"].inException());
    EXPECT_EQ(1u, statistics("b").failures);
    EXPECT_EQ(1u, statistics("b").left_out);
    EXPECT_TRUE(chain->isRunning());
}

TEST_F(ChainCycle, AStoppedMemberIsCounted) {
    ASSERT_TRUE(chain->start());
    (*this)["b"].stop();
    EXPECT_THAT(cycle(), ElementsAre("a", "c"));
    EXPECT_EQ(1u, statistics("b").left_out);
    EXPECT_EQ(0u, statistics("b").failures);
    (*this)["b"].start();
    EXPECT_THAT(cycle(), ElementsAre("a", "b", "c"));
}

TEST_F(ChainCycle, DeletedAndNewMembers) {
    ASSERT_TRUE(chain->start());
    cycle();
    members.erase(members.begin() + 1);
    EXPECT_THAT(cycle(), ElementsAre("a", "c"));
    add("b");
    EXPECT_THAT(cycle(), ElementsAre("a", "b", "c"));
    EXPECT_EQ(2u, statistics("b").times.count) << "those of its predecessor count, too";
    add("d");
    EXPECT_THAT(cycle(), ElementsAre("a", "b", "c", "d"));
    chain->removePeer("a");
    EXPECT_THAT(cycle(), ElementsAre("b", "c", "d"));
}

TEST_F(ChainCycle, AMemberThatWasAPeerBefore) {
    Member late("late", &trace);
    chain->addPeer(&late);
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(cycle(), ElementsAre("a", "b", "c"));
    late.setActivity(new RTT::extras::SlaveActivity(chain->getActivity()));
    late.start();
    EXPECT_TRUE(within(5, [&] { return cycle().size() == 4; }));
    late.stop();
    late.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, nullptr, "own"));
    EXPECT_TRUE(within(5, [&] {
        cycle();
        return chain->order().size() == 3;
    }));
}

TEST_F(ChainCycle, AMemberDeletesAnother) {
    (*this)["a"].each = [this] {
        if (members.size() == 3) members.erase(members.begin() + 1);
    };
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(cycle(), ElementsAre("a", "c"));
    EXPECT_THAT(cycle(), ElementsAre("a", "c"));
}

TEST_F(ChainCycle, Dividers) {
    set(*chain, "dividers", Strings{"a:2+1"});
    RTT::PropertyBag bag;
    bag.ownProperty(new RTT::Property<int>("b", "", 3));
    bag.ownProperty(new RTT::Property<std::string>("c", "", "3+2"));
    set(*chain, "divider", bag);
    ASSERT_TRUE(chain->start());
    Strings text;
    for (int i = 0; i < 6; ++i) {
        std::string all;
        for (const std::string& name : cycle()) all += name;
        text.push_back(all);
        if (i == 2) add("d");  // a new list keeps the rhythm
    }
    EXPECT_THAT(text, ElementsAre("b", "a", "c", "abd", "d", "acd"));
    EXPECT_EQ(0u, statistics("a").left_out);
}

TEST_F(ChainCycle, Budgets) {
    set(*chain, "budget", 0.004);
    RTT::PropertyBag bag;
    bag.ownProperty(new RTT::Property<double>("b", "", 0.001));
    set(*chain, "budgets", bag);
    RTT::InputPort<std::string> overrun("overrun", RTT::ConnPolicy::buffer(10));
    ASSERT_TRUE(overrun.connectTo(chain->getPort("overrun"), RTT::ConnPolicy::buffer(10)));
    ASSERT_TRUE(chain->start());
    int sleep = 0;
    (*this)["b"].each = [&] { std::this_thread::sleep_for(std::chrono::milliseconds(sleep)); };
    sleep = 6;
    cycle();
    std::string name;
    EXPECT_EQ(RTT::NewData, overrun.read(name));
    EXPECT_EQ("b", name);
    EXPECT_EQ(RTT::NewData, overrun.read(name));
    EXPECT_EQ("chain", name);
    EXPECT_EQ(1u, statistics("b").overruns);
    EXPECT_EQ(1u, chain->stats().overruns);
    EXPECT_TRUE(chain->isRunning());
    chain->stop();
    set(*chain, "stop_on_overrun", true);
    ASSERT_TRUE(chain->start());
    cycle();
    EXPECT_EQ(OCL::Chain::RunTimeError, chain->getTaskState());
}

TEST_F(ChainCycle, EachSampleIsACycle) {
    period(0);
    for (const auto& member : members) {
        member->stop();
        enslave(*chain, *member);
        member->start();
        member->updates = 0;
    }
    RTT::TaskContext writer("writer");
    RTT::OutputPort<int> trigger("t");
    RTT::OutputPort<double> clock("c");
    ASSERT_TRUE(trigger.connectTo(chain->getPort("trigger")) && clock.connectTo(chain->getPort("inClock")));
    ASSERT_TRUE(chain->start());
    for (int i = 0; i < 7; ++i) trigger.write(i);
    for (int i = 0; i < 4; ++i) clock.write(0.1 * i);
    RTT::extras::SlaveActivity& own = dynamic_cast<RTT::extras::SlaveActivity&>(*chain->getActivity());
    ASSERT_TRUE(own.serve());
    EXPECT_EQ(11, (*this)["a"].updates);
    EXPECT_EQ(11u, chain->stats().iteration);
    EXPECT_TRUE(chain->step());
    EXPECT_EQ(12, (*this)["c"].updates);
}

TEST_F(ChainCycle, PeriodicOnesMakeNoExtraSteps) {
    EXPECT_FALSE(chain->step());
    ASSERT_TRUE(chain->start());
    EXPECT_FALSE(chain->step());
}

TEST_F(ChainCycle, FurtherTriggers) {
    period(0);
    for (const auto& member : members) {
        member->stop();
        enslave(*chain, *member);
        member->start();
        member->updates = 0;
    }
    set(*chain, "triggers", Strings{"text:string"});
    ASSERT_TRUE(chain->configure());
    RTT::OutputPort<std::string> text("text");
    ASSERT_TRUE(text.connectTo(chain->getPort("text"), RTT::ConnPolicy::buffer(5)));
    ASSERT_TRUE(chain->start());
    text.write("one");
    text.write("two");
    dynamic_cast<RTT::extras::SlaveActivity&>(*chain->getActivity()).serve();
    EXPECT_EQ(2, (*this)["a"].updates);
}

TEST_F(ChainCycle, ManagedMembers) {
    for (const auto& member : members) {
        member->stop();
        member->traceLife = true;
    }
    set(*chain, "manage", true);
    order({"c", "a", "b"});
    trace.clear();
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(trace, ElementsAre("c starts", "a starts", "b starts"));
    EXPECT_THAT(cycle(), ElementsAre("c", "a", "b"));
    trace.clear();
    ASSERT_TRUE(chain->stop());
    EXPECT_THAT(trace, ElementsAre("b stops", "a stops", "c stops"));
    LogText log;
    (*this)["a"].starts = false;
    trace.clear();
    EXPECT_FALSE(chain->start());
    EXPECT_THAT(trace, ElementsAre("c starts", "a starts", "c stops"));
    EXPECT_THAT(log(), HasSubstr("chain 'chain' could not start its member 'a'"));
}

TEST_F(ChainCycle, MembersWithoutMasterMayBeNamed) {
    Member loose("loose", &trace);
    loose.setActivity(new RTT::extras::SlaveActivity(0.001));
    chain->addPeer(&loose);
    loose.start();
    order({"loose", "a"});
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(cycle(), ElementsAre("loose", "a"));
}

TEST_F(ChainCycle, TheSameSequenceInASimulation) {
    using RTT::extras::SimulationThread;
    const auto run = [&] {
        SimulationThread::Instance()->stop();
        chain->stop();
        members.clear();
        chain.reset(new OCL::Chain("chain"));
        chain->setActivity(new RTT::extras::SimulationActivity(0.01));
        for (const char* name : {"a", "b", "c"}) add(name);
        set(*chain, "dividers", Strings{"b:3+1"});
        Member& a = (*this)["a"];
        Member& c = (*this)["c"];
        a.out.connectTo(&c.event);
        a.each = [&a] { a.out.write(a.updates); };
        EXPECT_TRUE(chain->start());
        trace.clear();
        SimulationThread::Instance()->run(50);
        chain->stop();
        EXPECT_NEAR(0.0, chain->stats().jitter.max, 1e-9);
        return trace;
    };
    const Strings first = run();
    EXPECT_EQ(first, run());
    EXPECT_LT(100u, first.size());
    chain->stop();
    members.clear();
    chain.reset();
}

}  // namespace
