// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which members a chain has, in which order, and why it does not start.
#include "chain_fixture.hpp"

namespace {

using namespace chain_test;

class ChainOrder : public Chained {};

TEST_F(ChainOrder, AllSlavesInAlphabeticalOrder) {
    for (const char* name : {"c", "a", "b"}) add(name);
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(chain->order(), ElementsAre("a", "b", "c"));
    EXPECT_THAT(cycle(), ElementsAre("a", "b", "c"));
}

TEST_F(ChainOrder, OnlyNamedOnes) {
    for (const char* name : {"a", "b", "c"}) add(name);
    order({"c", "a"});
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(cycle(), ElementsAre("c", "a"));
}

TEST_F(ChainOrder, AStarStandsForAllOthers) {
    for (const char* name : {"a", "b", "c", "d"}) add(name);
    order({"d", "*", "a"});
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(cycle(), ElementsAre("d", "b", "c", "a"));
}

TEST_F(ChainOrder, HundredSlavesOfFbschedOfWhichTenAreNamed) {
    chain.reset(new FBSched("chain"));
    period(0.001);
    Strings all, named;
    for (int i = 100; i < 200; ++i) add("m" + std::to_string(i));
    for (int i = 0; i < 10; ++i) named.push_back("m" + std::to_string(195 - i));
    order(named);
    Strings expected = named;
    for (int i = 100; i < 200; ++i)
        if (i < 186 || i > 195) expected.push_back("m" + std::to_string(i));
    ASSERT_TRUE(chain->start());
    for (int i = 0; i < 100; ++i) EXPECT_EQ(expected, cycle());
    for (const auto& member : members) EXPECT_EQ(100, member->updates);
}

TEST_F(ChainOrder, AForeignPeerIsIgnored) {
    LogText log;
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Info);
    add("a");
    Member reporter("reporter", &trace);
    chain->addPeer(&reporter);
    ASSERT_TRUE(chain->start());
    EXPECT_THAT(cycle(), ElementsAre("a"));
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Warning);
    EXPECT_THAT(log(), HasSubstr("chain 'chain' does not execute its other peers 'reporter'"));
    EXPECT_EQ(0, chain->stats().failures);
}

TEST_F(ChainOrder, AllFindingsAtOnceWithHints) {
    LogText log;
    add("alpha");
    Member own("own", nullptr), other("other", nullptr);
    chain->addPeer(&own);
    OCL::Chain second("second");
    enslave(second, other);
    chain->addPeer(&other);
    chain->addPeer(chain.get());
    order({"alpha", "alpha", "alpa", "own", "other", "chain", "*", "*"});
    set(*chain, "on_error", std::string("ignore"));
    set(*chain, "dividers", Strings{"alpha:0", "alpha:2+2", "nobody:3", "x"});
    set(*chain, "budget", -1.0);
    set(*chain, "report_every", -1);
    set(*chain, "triggers", Strings{"nothing"});
    EXPECT_FALSE(chain->start());
    EXPECT_EQ(OCL::Chain::Stopped, chain->getTaskState());
    for (const char* part :
         {"'alpha' is twice in sched_order", "'alpa' of sched_order is no peer of 'chain'; did you mean 'alpha'?",
          "'own' is no slave; setMasterSlaveActivity(\"chain\", \"own\") is missing",
          "'other' is a slave of 'second', not of 'chain'; setMasterSlaveActivity(\"chain\", \"other\") is missing",
          "'chain' is the chain itself", "'*' is twice",
          "property on_error is 'ignore'; write one of skip, stop_cycle, stop", "divider '0' of 'alpha'",
          "divider '2+2' of 'alpha'", "a divider names 'nobody'", "divider 'x' names no member",
          "the budget of a cycle is -1", "property report_every is -1", "trigger 'nothing' is no input port"})
        EXPECT_THAT(log(), HasSubstr(part));
}

TEST_F(ChainOrder, WithoutMembersItDoesNotStart) {
    LogText log;
    EXPECT_FALSE(chain->start());
    EXPECT_THAT(log(), HasSubstr("there is no peer that is a slave of 'chain'"));
    EXPECT_THAT(chain->check(), HasSubstr("there is no peer that is a slave of 'chain'"));
    add("a");
    EXPECT_EQ("", chain->check());
    EXPECT_TRUE(chain->start());
}

TEST_F(ChainOrder, AMasterIsNoMemberOfItsSlave) {
    OCL::Chain outer("outer");
    outer.setActivity(new RTT::extras::SlaveActivity(0.001));
    enslave(outer, *chain);
    add("a");
    chain->addPeer(&outer);
    order({"a", "outer"});
    EXPECT_THAT(chain->check(), HasSubstr("'outer' executes the chain 'chain', so it cannot be a member"));
    members.clear();
    chain.reset();
}

TEST_F(ChainOrder, AValueReachesTheEndInTheSameCycle) {
    for (const char* name : {"a", "b", "c"}) add(name);
    auto& a = (*this)["a"];
    auto& b = (*this)["b"];
    auto& c = (*this)["c"];
    ASSERT_TRUE(a.out.connectTo(&b.in));
    ASSERT_TRUE(b.out.connectTo(&c.in));
    ASSERT_TRUE(c.out.connectTo(&a.in));
    a.each = [&] { a.out.write(a.updates); };
    b.each = [&] {
        int value = 0;
        b.in.read(value);
        b.out.write(value);
    };
    c.each = [&] {
        int value = 0;
        c.in.read(value);
        EXPECT_EQ(a.updates, value);
        c.out.write(value);
    };
    ASSERT_TRUE(chain->start());
    for (int i = 0; i < 100; ++i) cycle();
    EXPECT_EQ(100, c.updates);
    EXPECT_THAT(chain->describe(), HasSubstr("one cycle late: c.out → a.in"));
    EXPECT_THAT(chain->describe(), Not(HasSubstr("a.out")));
    EXPECT_THAT(chain->dot(), HasSubstr("\"c\" -> \"a\" [constraint=false, style=dashed"));
    EXPECT_THAT(chain->dot(), HasSubstr("\"a\" -> \"b\" [style=bold]"));
}

TEST_F(ChainOrder, NestedChains) {
    OCL::Chain inner("inner");
    add("a");
    enslave(*chain, inner);
    add("z");
    Member x("x", &trace), y("y", &trace);
    enslave(inner, x);
    enslave(inner, y);
    set(inner, "sched_order", Strings{"y", "x"});
    ASSERT_TRUE(x.start() && y.start() && inner.start() && chain->start());
    EXPECT_THAT(cycle(), ElementsAre("a", "y", "x", "z"));
    EXPECT_EQ(1u, inner.stats().cycle.count);
    EXPECT_LE(inner.stats().cycle.max, statistics("inner").times.max);
    EXPECT_THAT(chain->timeReport(), HasSubstr("chain 'inner', 1 cycles"));
    chain->stop();
    inner.stop();
}

}  // namespace
