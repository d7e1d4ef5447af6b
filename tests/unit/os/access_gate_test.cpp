// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/internal/engine/access_gate.hpp>

#include <memory>
#include <thread>
#include <vector>

using oroforge::test::eventually;
using RTT::internal::AccessGate;

TEST(AccessGate, LetsNobodyInAfterItWasClosed) {
    const auto gate = std::make_shared<AccessGate>();
    gate->share();
    EXPECT_TRUE(AccessGate::Pass(gate));
    gate->close();
    EXPECT_FALSE(AccessGate::Pass(gate));
    gate->close();
    gate->open();
    EXPECT_TRUE(AccessGate::Pass(gate));
    EXPECT_FALSE(AccessGate::Pass(nullptr));
}

TEST(AccessGate, CloseWaitsForThoseInside) {
    const auto gate = std::make_shared<AccessGate>();
    gate->share();
    std::atomic<bool> inside{false}, left{false};
    std::thread user([&] {
        const AccessGate::Pass pass(gate);
        const AccessGate::Pass nested(gate);
        inside = true;
        usleep(20000);
        left = true;
    });
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    gate->close();
    EXPECT_TRUE(left);
    user.join();
}

TEST(AccessGate, WhoIsInsideMayCloseIt) {
    auto gate = std::make_shared<AccessGate>();
    gate->share();
    const auto other = std::make_shared<AccessGate>();
    other->share();
    const AccessGate::Pass pass(gate);
    const AccessGate::Pass between(other);
    const AccessGate::Pass nested(gate);
    gate->closeForGood();
    EXPECT_FALSE(AccessGate::Pass(gate));
    EXPECT_TRUE(AccessGate::Pass(other));
    gate.reset();  // the passes do not look at it any more
}

TEST(AccessGate, ClosingWithinAPassDoesNotEndThePass) {
    const auto gate = std::make_shared<AccessGate>();
    gate->share();
    const AccessGate::Pass pass(gate);
    gate->close();
    gate->open();
    std::thread([&] { EXPECT_TRUE(RTT::internal::Presence::Waiter(gate.get()).others()); }).join();
}

TEST(AccessGateStorm, WhatItProtectsIsNeverUsedAfterItsEnd) {
    for (int round = 0; round < 300; ++round) {
        const auto gate = std::make_shared<AccessGate>();
        gate->share();
        auto object = std::make_unique<int>(0);  // not atomic: ThreadSanitizer sees a use that is not over
        int* const pointer = object.get();
        std::vector<std::thread> users;
        std::atomic<int> refused{0};
        for (int i = 0; i < 2; ++i)
            users.emplace_back([&] {
                for (;;) {
                    const AccessGate::Pass pass(gate);
                    if (!pass) break;
                    EXPECT_GE(__atomic_fetch_add(pointer, 1, __ATOMIC_RELAXED), 0);
                }
                ++refused;
            });
        gate->close();
        *pointer = -1;
        object.reset();
        for (std::thread& user : users) user.join();
        EXPECT_EQ(refused, 2);
    }
}
