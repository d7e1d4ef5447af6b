// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/internal/engine/wait_point.cpp>

namespace {

using model::Trial;
using RTT::internal::WaitPoint;

/** Waits as the class comment says. The condition has no order of its own. */
void waitFor(WaitPoint& point, const std::atomic<int>& condition) {
    for (;;) {
        const std::uint32_t ticket = point.ticket();
        if (condition.load(std::memory_order_relaxed) != 0) return;
        point.wait(ticket);
    }
}

template <int waiters>
void oneNotifier(Trial& trial) {
    WaitPoint point;
    std::atomic<int> condition{0};
    trial.thread([&] {
        condition.store(1, std::memory_order_relaxed);
        point.notify();
    });
    for (int i = 0; i < waiters; ++i) trial.thread([&] { waitFor(point, condition); });
    trial.go();
}

/** Each waits for something else at the same point. */
void twoNotifiers(Trial& trial) {
    WaitPoint point;
    std::array<std::atomic<int>, 2> conditions{};
    for (std::size_t i = 0; i < 2; ++i) {
        trial.thread([&, i] {
            conditions[i].store(1, std::memory_order_relaxed);
            point.notify();
        });
    }
    trial.thread([&] {
        waitFor(point, conditions[0]);
        waitFor(point, conditions[1]);
    });
    trial.go();
    model::require(model::futexCalls().wakes <= model::futexCalls().waits, "woken more often than it went to sleep");
}

TEST(WaitPoint, one_waiter) { EXPECT_TRUE(model::holds(oneNotifier<1>)); }
TEST(WaitPoint, two_waiters) { EXPECT_TRUE(model::holds(oneNotifier<2>)); }
TEST(WaitPoint, two_notifiers) { EXPECT_TRUE(model::holds(twoNotifiers)); }

TEST(WaitPoint, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("wait_relaxed_notify", oneNotifier<1>));
    EXPECT_TRUE(model::catches("wait_relaxed_ticket", oneNotifier<1>));
    EXPECT_TRUE(model::catches("wait_sleeps_unseen", oneNotifier<1>));
    EXPECT_TRUE(model::catches("wait_one_woken", oneNotifier<2>));
    EXPECT_TRUE(model::catches("wait_woken_twice", twoNotifiers));
}

}  // namespace
