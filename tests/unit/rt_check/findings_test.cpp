// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The table in which --rt-check counts.
#include <rt_check/findings.hpp>

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace oroforge::rt_check {
namespace {

char code[100000];

class Findings : public testing::Test {
protected:
    void SetUp() override {
        for (Finding& finding : findings) finding.state = Finding::kFree;
    }

    static bool countFrom(std::size_t place, const char* component = "one", const char* function = "malloc",
                          oroforge_rt_fault fault = OROFORGE_RT_ALLOCATION,
                          oroforge_rt_place during = OROFORGE_RT_UPDATE) {
        void* const frames[] = {&code[place], &code[1]};
        return count({component, during, fault, function, frames, 2, ""});
    }
    /** How many findings there are, and how many calls they stand for. */
    static std::pair<std::size_t, unsigned long> sum() {
        std::pair<std::size_t, unsigned long> result{0, 0};
        forEachFinding([&result](const Finding& finding) { ++result.first, result.second += finding.count; });
        return result;
    }
};

TEST_F(Findings, CallsFromOnePlaceAreOne) {
    for (int i = 0; i != 5; ++i) EXPECT_TRUE(countFrom(7));
    EXPECT_EQ(std::make_pair(std::size_t(1), 5ul), sum());
}

TEST_F(Findings, WhateverDiffersMakesAnother) {
    EXPECT_TRUE(countFrom(7));
    EXPECT_TRUE(countFrom(8));
    EXPECT_TRUE(countFrom(7, "two"));
    EXPECT_TRUE(countFrom(7, "one", "calloc"));
    EXPECT_TRUE(countFrom(7, "one", "malloc", OROFORGE_RT_RELEASE));
    EXPECT_TRUE(countFrom(7, "one", "malloc", OROFORGE_RT_ALLOCATION, OROFORGE_RT_SCRIPT));
    EXPECT_EQ(std::make_pair(std::size_t(6), 6ul), sum());
}

TEST_F(Findings, LongNamesAndDeepStacksAreCut) {
    const std::string name(1000, 'n');
    std::vector<void*> frames(1000, code);
    for (int i = 0; i != 2; ++i)
        EXPECT_TRUE(
            count({name.c_str(), OROFORGE_RT_UPDATE, OROFORGE_RT_LOCK, "pthread_mutex_lock", frames.data(), 1000, ""}));
    EXPECT_EQ(std::make_pair(std::size_t(1), 2ul), sum());
    forEachFinding([](const Finding& finding) {
        EXPECT_EQ(std::string(Finding::kLongestName - 1, 'n'), finding.component);
        EXPECT_EQ(+Finding::kMaxFrames, finding.depth);
    });
}

TEST_F(Findings, AFullTableSaysSoAndGoesOnCountingWhatItHas) {
    for (std::size_t i = 0; i != kFindings; ++i) ASSERT_TRUE(countFrom(i + 10));
    EXPECT_FALSE(countFrom(kFindings + 10));
    EXPECT_TRUE(countFrom(10));
    EXPECT_EQ(std::make_pair(kFindings, kFindings + 1ul), sum());
}

TEST_F(Findings, ThreadsCountTogether) {
    constexpr int kThreads = 4, kCalls = 20000, kPlaces = 50;
    std::vector<std::thread> threads;
    for (int t = 0; t != kThreads; ++t)
        threads.emplace_back([] {
            for (int i = 0; i != kCalls; ++i) EXPECT_TRUE(countFrom(10 + i % kPlaces));
        });
    for (std::thread& thread : threads) thread.join();
    // A place may have two entries, if two threads made it at once.
    EXPECT_GE(sum().first, std::size_t(kPlaces));
    EXPECT_EQ(1ul * kThreads * kCalls, sum().second);
}

TEST_F(Findings, FramesAreDescribedOnce) {
    EXPECT_TRUE(countFrom(7));
    describeFindings();
    const char* first = nullptr;
    forEachFinding([&first](const Finding& finding) { first = finding.texts[0]; });
    ASSERT_NE(nullptr, first);
    describeFindings();
    forEachFinding([first](const Finding& finding) {
        EXPECT_EQ(first, finding.texts[0]);
        EXPECT_FALSE(finding.isAllowed());
    });
}

}  // namespace
}  // namespace oroforge::rt_check
