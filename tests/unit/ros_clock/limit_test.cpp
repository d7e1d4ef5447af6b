// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a step of the clock catches up.
#include "clock_test.hpp"

#include <rtt/Logger.hpp>

#include <sstream>

namespace {

using namespace oroforge::test;
using rtt_rosclock::SimClockActivity;

struct Limit : ManualClock {
    Limit() {
        RTT::Logger::Instance()->setLogLevel(RTT::Logger::Warning);
        RTT::Logger::Instance()->setStdStream(log);
    }
    ~Limit() override {
        RTT::Logger::Instance()->setStdStream(std::cerr);
        EXPECT_TRUE(rtt_rosclock::set_catch_up_limit(1000));
    }
    int warnings() const {
        int count = 0;
        const std::string text = log.str(), word = "was due";
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
        return count;
    }
    std::ostringstream log;
};

TEST_F(Limit, CoarseStepsOfTheClockKeepAFastActivityExact) {
    Recorder r;
    SimClockActivity a(0.001, &r);
    ASSERT_TRUE(a.start());
    for (nsecs step = 1; step <= 50; ++step) ASSERT_TRUE(update(step * 200 * kMs));
    ASSERT_EQ(r.at.size(), 10000u);
    for (std::size_t i = 0; i != r.at.size(); ++i) ASSERT_EQ(r.at[i], static_cast<nsecs>(i + 1) * kMs);
    EXPECT_EQ(warnings(), 0);
}

TEST_F(Limit, EachActivityHasItsOwn) {
    EXPECT_EQ(rtt_rosclock::catch_up_limit(), 1000);
    EXPECT_FALSE(rtt_rosclock::set_catch_up_limit(-1));
    ASSERT_TRUE(rtt_rosclock::set_catch_up_limit(10));
    Recorder fast, exact, every;
    SimClockActivity a(0.01, &fast, "a"), b(0.1, &exact, "b"), c(&every);
    ASSERT_TRUE(a.start() && b.start() && c.start());
    ASSERT_TRUE(update(10 * kMs) && update(315 * kMs) && update(325 * kMs));
    EXPECT_EQ(fast.at, (std::vector<nsecs>{10 * kMs, 315 * kMs, 320 * kMs}));
    EXPECT_EQ(exact.at, (std::vector<nsecs>{100 * kMs, 200 * kMs, 300 * kMs}));
    EXPECT_EQ(every.at, (std::vector<nsecs>{10 * kMs, 315 * kMs, 325 * kMs}));
    fast.at.clear();
    ASSERT_TRUE(update(420 * kMs));  // as often as is caught up
    EXPECT_EQ(fast.at.size(), 10u);
    fast.at.clear();
    exact.at.clear();
    ASSERT_TRUE(update(4294967295ll * 1000000000 + 999999999));
    EXPECT_EQ(fast.at.size(), 1u);
    EXPECT_EQ(exact.at.size(), 1u);
}

TEST_F(Limit, IsWarnedOfOnceUntilAStepIsWithinIt) {
    ASSERT_TRUE(rtt_rosclock::set_catch_up_limit(10));
    Recorder r;
    SimClockActivity a(0.01, &r, "busy one");
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(update(1000 * kMs));  // enabled late
    EXPECT_EQ(warnings(), 0);
    ASSERT_TRUE(update(2000 * kMs) && update(3000 * kMs) && update(4000 * kMs));
    EXPECT_EQ(warnings(), 1);
    EXPECT_NE(log.str().find("'busy one' was due 100 times"), std::string::npos) << log.str();
    ASSERT_TRUE(update(4010 * kMs) && update(5000 * kMs) && update(6000 * kMs));
    EXPECT_EQ(warnings(), 2);
    EXPECT_EQ(r.at.size(), 7u);
}

TEST_F(Limit, HoldsAlsoForAPeriodThatBecomesShortInTheStep) {
    Recorder r;
    SimClockActivity a(0.1, &r);
    r.onStep = [&] { a.setPeriod(1e-9); };
    ASSERT_TRUE(a.start() && update(1000 * kMs));
    EXPECT_EQ(r.at, (std::vector<nsecs>{100 * kMs, 1000 * kMs}));
}

TEST_F(Limit, OfZeroExecutesAtTheTimesOfTheClock) {
    ASSERT_TRUE(rtt_rosclock::set_catch_up_limit(0));
    Recorder r;
    SimClockActivity a(0.01, &r);
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(update(15 * kMs) && update(18 * kMs) && update(45 * kMs));
    EXPECT_EQ(r.at, (std::vector<nsecs>{15 * kMs, 45 * kMs}));
}

}  // namespace
