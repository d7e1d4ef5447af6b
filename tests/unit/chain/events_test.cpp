// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// When members of a chain execute messages and callbacks.
#include "chain_fixture.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <future>

namespace {

using namespace chain_test;
typedef RTT::OperationCaller<std::string()> Hello;

/** A chain with a thread of its own. */
class ChainEvents : public Chained {
protected:
    void SetUp() override {}
    void begin(double seconds, const std::string& events) {
        thread(seconds);
        set(*chain, "events", events);
        for (const char* name : {"a", "b", "c"}) add(name);
    }
    void TearDown() override {
        chain->stop();
        for (const auto& member : members) member->stop();
    }
    int position(const std::string& what) const {
        for (std::size_t i = 0; i != trace.size(); ++i)
            if (trace[i] == what) return static_cast<int>(i);
        return -1;
    }
};

TEST_F(ChainEvents, AnEventPortWaitsForItsTurn) {
    begin(0.2, "in_order");
    Member& b = (*this)["b"];
    RTT::OutputPort<int> out("out");
    ASSERT_TRUE(out.connectTo(&b.event));
    ASSERT_TRUE(chain->start());
    ASSERT_TRUE(within(2, [&] { return (*this)["c"].updates >= 1; }));
    const int before = b.updates;
    out.write(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(before, b.updates);
    EXPECT_TRUE(within(2, [&] { return b.updates > before; }));
    chain->stop();
    for (std::size_t i = 0; i != trace.size(); ++i) EXPECT_EQ(std::string(1, "abc"[i % 3]), trace[i]) << i;
}

TEST_F(ChainEvents, AnOperationWaitsForItsTurn) {
    begin(0.1, "in_order");
    ASSERT_TRUE(chain->start());
    ASSERT_TRUE(within(2, [&] { return (*this)["c"].updates >= 1; }));
    Hello hello((*this)["b"].getOperation("hello"), RTT::internal::GlobalEngine::Instance());
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ("hello from b", hello());
    EXPECT_GT(std::chrono::milliseconds(150), std::chrono::steady_clock::now() - begin);
    chain->stop();
    const int at = position("b.hello");
    ASSERT_LT(0, at);
    EXPECT_EQ("a", trace[static_cast<std::size_t>(at - 1)]);
    EXPECT_EQ("b", trace[static_cast<std::size_t>(at + 1)]);
}

TEST_F(ChainEvents, AtOnceMeansBetweenCycles) {
    begin(1.0, "at_once");
    ASSERT_TRUE(chain->start());
    ASSERT_TRUE(within(3, [&] { return (*this)["c"].updates >= 1; }));
    Hello hello((*this)["b"].getOperation("hello"), RTT::internal::GlobalEngine::Instance());
    const int before = (*this)["a"].updates;
    EXPECT_EQ("hello from b", hello());
    EXPECT_EQ(before, (*this)["a"].updates);
}

TEST_F(ChainEvents, AStoppedChainServesAsBefore) {
    begin(0.0, "in_order");
    Hello hello((*this)["b"].getOperation("hello"), RTT::internal::GlobalEngine::Instance());
    EXPECT_EQ("hello from b", hello());
    ASSERT_TRUE(chain->start());
    EXPECT_EQ("hello from b", hello()) << "not periodic, so no cycle may come";
    ASSERT_TRUE(chain->stop());
    EXPECT_EQ("hello from b", hello());
    EXPECT_EQ(0, (*this)["b"].updates) << "a start is no cycle";
}

TEST_F(ChainEvents, WhatWasDeferredIsServedAfterAStop) {
    begin(100.0, "in_order");
    ASSERT_TRUE(chain->start());
    ASSERT_TRUE(within(2, [&] { return chain->stats().iteration == 0; }));
    Hello hello((*this)["b"].getOperation("hello"), RTT::internal::GlobalEngine::Instance());
    auto handle = hello.send();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_TRUE(chain->stop());
    std::string result;
    ASSERT_EQ(RTT::SendSuccess, handle.collect(result));
    EXPECT_EQ("hello from b", result);
}

TEST_F(ChainEvents, ADividedMemberServesInEachCycle) {
    begin(0.02, "in_order");
    set(*chain, "dividers", Strings{"b:100000+50000"});
    ASSERT_TRUE(chain->start());
    Hello hello((*this)["b"].getOperation("hello"), RTT::internal::GlobalEngine::Instance());
    EXPECT_EQ("hello from b", hello());
    EXPECT_EQ(0, (*this)["b"].updates);
}

TEST_F(ChainEvents, MembersBehindAFailureServe) {
    LogText log;
    begin(0.02, "in_order");
    set(*chain, "on_error", std::string("stop_cycle"));
    ASSERT_TRUE(chain->start());
    (*this)["a"].getActivity()->stop();
    Hello hello((*this)["b"].getOperation("hello"), RTT::internal::GlobalEngine::Instance());
    EXPECT_EQ("hello from b", hello());
    chain->stop();
    set(*chain, "on_error", std::string("stop"));
    ASSERT_TRUE(chain->start());
    ASSERT_TRUE(within(2, [&] { return chain->inRunTimeError(); }));
    EXPECT_EQ("hello from b", hello());
    (*this)["a"].getActivity()->start();
}

class ChainCalls : public ChainEvents, public testing::WithParamInterface<const char*> {};

// The thread of the chain waits, and what it waits for needs a member of the chain.
TEST_P(ChainCalls, FromWithinDoNotDeadlock) {
    begin(0.005, GetParam());
    Member& a = (*this)["a"];
    Member& b = (*this)["b"];
    Member& c = (*this)["c"];
    Hello direct(b.getOperation("hello"), a.engine()), back(a.getOperation("hello"), c.engine());
    RTT::TaskContext outside("outside");
    Hello there(b.getOperation("hello"), outside.engine());
    RTT::Operation<std::string()> relay(
        "relay", [&] { return "relayed " + there(); }, RTT::OwnThread);
    outside.addOperation(relay);
    Hello around(outside.getOperation("relay"), a.engine());
    std::atomic<int> good{0};
    a.each = [&] { good += direct() == "hello from b" && around() == "relayed hello from b"; };
    c.each = [&] { good += back() == "hello from a"; };
    ASSERT_TRUE(chain->start());
    EXPECT_TRUE(within(10, [&] { return good >= 20; })) << good;
    chain->stop();
    a.stop();
    outside.stopForGood();
}

// An operation of the chain itself waits.
TEST_P(ChainCalls, FromAnOperationOfTheChainDoNotDeadlock) {
    begin(0.005, GetParam());
    RTT::TaskContext outside("outside");
    Hello there((*this)["b"].getOperation("hello"), outside.engine());
    RTT::Operation<std::string()> relay(
        "relay", [&] { return "relayed " + there(); }, RTT::OwnThread);
    outside.addOperation(relay);
    Hello around(outside.getOperation("relay"), chain->engine());
    RTT::Operation<std::string()> ask(
        "ask", [&] { return around(); }, RTT::OwnThread);
    chain->addOperation(ask);
    ASSERT_TRUE(chain->start());
    Hello asked(chain->getOperation("ask"), RTT::internal::GlobalEngine::Instance());
    EXPECT_EQ("relayed hello from b", asked());
    chain->stop();
    outside.stopForGood();
}

TEST_P(ChainCalls, InNestedChains) {
    begin(0.005, GetParam());
    OCL::Chain inner("inner");
    set(inner, "events", std::string(GetParam()));
    enslave(*chain, inner);
    Member x("x", nullptr);
    enslave(inner, x);
    ASSERT_TRUE(x.start() && inner.start() && chain->start());
    Hello fromInside(x.getOperation("hello"), (*this)["a"].engine());
    std::atomic<int> good{0};
    (*this)["a"].each = [&] { good += fromInside() == "hello from x"; };
    Hello hello(x.getOperation("hello"), RTT::internal::GlobalEngine::Instance());
    EXPECT_EQ("hello from x", hello());
    EXPECT_TRUE(within(5, [&] { return good >= 3; }));
    chain->stop();
    inner.stop();
    (*this)["a"].stop();
}

INSTANTIATE_TEST_SUITE_P(Events, ChainCalls, testing::Values("in_order", "at_once"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
