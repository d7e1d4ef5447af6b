// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/os/detail/wake_word.hpp>

namespace {

using model::require;
using model::Trial;
using RTT::os::detail::kForever;
using RTT::os::detail::WakeWord;

/** Two reasons from two threads: both arrive, each with what was written before it. */
void twoPosters(Trial& trial) {
    WakeWord word;
    unsigned waits = 0;
    std::array<model::Plain<int>, 2> data;
    for (std::uint32_t i = 0; i < 2; ++i)
        trial.thread([&, i] {
            data[i] = 1;
            word.post(1u << i);
        });
    trial.thread([&] {
        std::uint32_t got = 0;
        while (got != 3) {
            ++waits;
            const std::uint32_t reasons = word.wait(kForever);
            require(reasons != 0, "woken without a reason");
            require((got & reasons) == 0, "a reason came twice");
            for (std::uint32_t i = 0; i < 2; ++i)
                if (reasons >> i & 1) require(data[i] == 1, "the reason came before what it is about");
            got |= reasons;
        }
    });
    trial.go();
    require(model::futexCalls().wakes <= waits, "woken more often than it went to sleep");
}

/** The same reason again and again: after the last post the owner sees all that was done before it. */
void postedAgain(Trial& trial) {
    WakeWord word;
    unsigned waits = 0;
    std::atomic<int> done{0};
    trial.thread([&] {
        for (int i = 1; i <= 3; ++i) {
            done.store(i, std::memory_order_relaxed);
            word.post(1);
        }
    });
    trial.thread([&] {
        for (; done.load(std::memory_order_relaxed) != 3; ++waits) word.wait(kForever);
    });
    trial.go();
    require(model::futexCalls().wakes <= waits, "woken more often than it went to sleep");
}

TEST(WakeWord, two_posters) { EXPECT_TRUE(model::holds(twoPosters)); }
TEST(WakeWord, the_same_reason_again) { EXPECT_TRUE(model::holds(postedAgain)); }

TEST(WakeWord, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("wake_relaxed_post", twoPosters));
    EXPECT_TRUE(model::catches("wake_relaxed_take", twoPosters));
    EXPECT_TRUE(model::catches("wake_sleeps_over_reasons", twoPosters));
    EXPECT_TRUE(model::catches("wake_post_left_out", postedAgain));
    EXPECT_TRUE(model::catches("wake_more_than_once", twoPosters));
}

}  // namespace
