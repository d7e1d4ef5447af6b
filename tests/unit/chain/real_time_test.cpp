// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A cycle neither allocates nor locks nor waits.
#include "chain_fixture.hpp"

#include <support/real_time_trap.hpp>

namespace {

using namespace chain_test;
using oroforge::test::expectRealTime;

class ChainRealTime : public Chained {
protected:
    void SetUp() override {
        Chained::SetUp();
        for (int i = 0; i < 100; ++i) members.push_back(std::make_unique<Member>("m" + std::to_string(i), nullptr));
        for (const auto& member : members) {
            enslave(*chain, *member);
            ASSERT_TRUE(member->start());
            member->updates = 0;  // a slave executes one step when it starts
        }
    }
};

TEST_F(ChainRealTime, WithStatisticsOverrunsAndFailures) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    LogText log;
    set(*chain, "report_every", 3);
    set(*chain, "budget", 1e-9);
    RTT::InputPort<OCL::ChainStatistics> statistics("s");
    RTT::InputPort<std::string> overrun("o");
    RTT::InputPort<unsigned> iteration("i");
    ASSERT_TRUE(statistics.connectTo(chain->getPort("statistics")));
    ASSERT_TRUE(overrun.connectTo(chain->getPort("overrun"), RTT::ConnPolicy::buffer(10)));
    ASSERT_TRUE(iteration.connectTo(chain->getPort("iteration")));
    ASSERT_TRUE(chain->start());
    chain->update();
    members[3]->getActivity()->stop();
    members[4]->stop();
    for (int i = 0; i < 20; ++i) expectRealTime([this] { chain->update(); });
    OCL::ChainStatistics sample;
    EXPECT_EQ(RTT::NewData, statistics.read(sample));
    EXPECT_EQ(100u, sample.members.size());
    EXPECT_LT(0u, sample.failures);
    members[3]->getActivity()->start();
}

TEST_F(ChainRealTime, WhilePeersComeAndGo) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    ASSERT_TRUE(chain->start());
    chain->update();
    for (int i = 0; i < 20; ++i) {
        Member* const more = new Member("more" + std::to_string(i), nullptr);
        enslave(*chain, *more);
        more->start();
        expectRealTime([this] { chain->update(); });
        EXPECT_EQ(1, more->updates);
        delete more;
        expectRealTime([this] { chain->update(); });
    }
}

TEST_F(ChainRealTime, WithSamplesAsTriggers) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    RTT::OutputPort<int> trigger("t");
    ASSERT_TRUE(trigger.connectTo(chain->getPort("trigger")));
    ASSERT_TRUE(chain->start());
    chain->update();
    expectRealTime([&] {
        trigger.write(1);
        trigger.write(2);
        chain->update();
    });
    EXPECT_EQ(4, members[0]->updates);
}

}  // namespace
