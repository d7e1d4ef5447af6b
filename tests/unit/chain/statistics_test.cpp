// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a chain measures.
#include "chain_fixture.hpp"

#include <chain/times.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace chain_test;
using OCL::ChainTimes;
using OCL::chain::Times;

ChainTimes read(const Times& times) {
    ChainTimes result;
    times.read(result);
    return result;
}

TEST(ChainTimesTest, AgreeWithWhatIsComputedFromAll) {
    std::mt19937 random(7);
    std::lognormal_distribution<double> values(10, 1.5);
    Times times;
    std::vector<double> all;
    double sum = 0, squares = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto value = static_cast<std::int64_t>(values(random));
        times.add(value);
        all.push_back(static_cast<double>(value));
        sum += all.back();
        squares += all.back() * all.back();
    }
    std::sort(all.begin(), all.end());
    const double mean = sum / 20000;
    const ChainTimes got = read(times);
    EXPECT_EQ(20000u, got.count);
    EXPECT_NEAR(all.front() * 1e-9, got.min, 1e-15);
    EXPECT_NEAR(all.back() * 1e-9, got.max, 1e-15);
    EXPECT_NEAR(mean * 1e-9, got.mean, mean * 1e-15);
    EXPECT_NEAR(std::sqrt(squares / 20000 - mean * mean) * 1e-9, got.deviation, mean * 1e-14);
    EXPECT_NEAR(all[19979] * 1e-9, got.p999, all[19979] * 0.04e-9);
}

TEST(ChainTimesTest, QuantilesOfRisingAndFallingValues) {
    for (const bool falls : {false, true}) {
        Times times;
        for (int i = 0; i < 10000; ++i) times.add(1000 * ((falls ? 10000 - i : i + 1)));
        EXPECT_NEAR(9.99e-3, read(times).p999, 0.4e-3) << falls;
    }
    Times times;
    times.add(INT64_MAX / 2);
    times.add(-5);
    EXPECT_EQ(0.0, read(times).min);
    times.reset();
    EXPECT_EQ(0u, read(times).count);
    EXPECT_EQ(0.0, read(times).p999);
    times.add(3);
    EXPECT_NEAR(3e-9, read(times).p999, 1e-12);
}

class ChainStatistics : public Chained {
protected:
    /** A member that measures itself. */
    struct Busy {
        double sum = 0, max = 0;
        int late = 0;
    };
    static void busy(Busy& own, double seconds, double budget) {
        const auto begin = std::chrono::steady_clock::now();
        double passed = 0;
        while (passed < seconds)
            passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        own.sum += passed;
        own.max = std::max(own.max, passed);
        own.late += passed > budget;
    }
};

TEST_F(ChainStatistics, OfAMemberThatTakesAKnownTime) {
    Member& slow = add("slow");
    add("swift");
    Busy own;
    int number = 0;
    slow.each = [&] { busy(own, ++number % 10 == 0 ? 0.006 : 0.002, 0.004); };
    RTT::PropertyBag bag;
    bag.ownProperty(new RTT::Property<double>("slow", "", 0.004));
    set(*chain, "budgets", bag);
    set(*chain, "report_every", 50);
    RTT::InputPort<OCL::ChainStatistics> port("port");
    RTT::InputPort<unsigned> iteration("iteration");
    ASSERT_TRUE(port.connectTo(chain->getPort("statistics")) && iteration.connectTo(chain->getPort("iteration")));
    ASSERT_TRUE(chain->start());
    for (int i = 0; i < 50; ++i) cycle();
    OCL::ChainStatistics sample;
    ASSERT_EQ(RTT::NewData, port.read(sample));
    unsigned last = 0;
    ASSERT_EQ(RTT::NewData, iteration.read(last));
    EXPECT_EQ(49u, last);
    ASSERT_EQ(2u, sample.members.size());
    const OCL::ChainMember& row = sample.members[0];
    EXPECT_EQ("slow", row.name);
    EXPECT_EQ(50u, row.times.count);
    EXPECT_NEAR(own.sum / 50, row.times.mean, own.sum / 50 * 0.05);
    EXPECT_NEAR(own.max, row.times.max, own.max * 0.05);
    EXPECT_EQ(static_cast<unsigned>(own.late), row.overruns);
    EXPECT_LE(5u, row.overruns);
    EXPECT_EQ(50u, sample.iteration);
    EXPECT_EQ(50u, sample.cycle.count);
    EXPECT_NEAR(sample.cycle.mean / 0.001, sample.utilisation, 1e-9);
    EXPECT_EQ(49u, sample.jitter.count);
    const std::string report = chain->timeReport();
    for (const char* part : {"slow", "swift", "cycle", "jitter", "utilisation", "last 49 periods/us"})
        EXPECT_THAT(report, HasSubstr(part));
}

TEST_F(ChainStatistics, AreForgotten) {
    add("a");
    ASSERT_TRUE(chain->start());
    for (int i = 0; i < 5; ++i) cycle();
    EXPECT_EQ(5u, statistics("a").times.count);
    chain->resetStats();
    cycle();
    EXPECT_EQ(1u, statistics("a").times.count);
    EXPECT_EQ(1u, chain->stats().cycle.count);
    EXPECT_EQ(6u, chain->stats().iteration);
    chain->stop();
    EXPECT_EQ(1u, statistics("a").times.count);
    chain->resetStats();
    EXPECT_EQ(0u, statistics("a").times.count);
}

TEST_F(ChainStatistics, KeepTheLastPeriods) {
    LogText log;
    add("a");
    EXPECT_TRUE(chain->setMaxBufferSize(10));
    ASSERT_TRUE(chain->start());
    for (int i = 0; i < 25; ++i) cycle();
    EXPECT_THAT(chain->timeReport(), HasSubstr("last 10 periods"));
    EXPECT_TRUE(chain->setMaxBufferSize(4));
    for (int i = 0; i < 25; ++i) cycle();
    EXPECT_THAT(chain->timeReport(), HasSubstr("last 4 periods"));
    EXPECT_FALSE(chain->setMaxBufferSize(0));
    EXPECT_FALSE(chain->setMaxBufferSize(100000000));
    EXPECT_THAT(log(), HasSubstr("setMaxBufferSize() takes a number from 1 to 1000000"));
}

}  // namespace
