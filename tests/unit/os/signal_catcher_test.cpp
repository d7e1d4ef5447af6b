// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Catchers of signals that several threads make and give up in any order.
#include <rtt/os/SignalCatcher.hpp>

#include <atomic>
#include <csignal>
#include <gtest/gtest.h>
#include <initializer_list>
#include <memory>
#include <optional>
#include <thread>

#include <poll.h>

namespace {

using RTT::os::pendingSignal;
using RTT::os::SignalCatcher;

TEST(SignalCatchers, AreGivenUpInAnyOrder) {
    std::optional<SignalCatcher> first(std::in_place, {SIGUSR1, SIGTERM});
    std::optional<SignalCatcher> second(std::in_place, {SIGUSR1}), third(std::in_place, {SIGUSR1});
    first.reset();
    raise(SIGUSR1);
    EXPECT_TRUE(third->caught());
    EXPECT_EQ(SIGUSR1, third->wait());
    third.reset();
    raise(SIGUSR1);
    EXPECT_EQ(SIGUSR1, second->wait());
    second.reset();
    struct sigaction action = {};
    for (const int signal : {SIGUSR1, SIGTERM}) {
        sigaction(signal, nullptr, &action);
        EXPECT_EQ(SIG_DFL, action.sa_handler);
    }
}

TEST(SignalCatchers, TakeTheirOwnSignalsOnly) {
    std::atomic<int> others{0};
    static std::atomic<int>* counter;
    counter = &others;
    void (*const before)(int) = std::signal(SIGTERM, [](int) { ++*counter; });
    for (int i = 0; i != 3; ++i) {
        SignalCatcher catcher({SIGTERM});
        pollfd descriptor = {catcher.descriptor(), POLLIN, 0};
        EXPECT_EQ(poll(&descriptor, 1, 0), 0);
        raise(SIGTERM);
        EXPECT_EQ(poll(&descriptor, 1, 0), 1);
    }
    EXPECT_EQ(others, 0);
    raise(SIGTERM);
    EXPECT_EQ(others, 1);
    std::signal(SIGTERM, before);
}

TEST(SignalCatchers, OnlyThoseThatEndTheProgramArePending) {
    SignalCatcher ending({SIGTERM});
    SignalCatcher other({SIGUSR1});
    raise(SIGUSR1);
    EXPECT_TRUE(other.caught());
    EXPECT_EQ(0, pendingSignal());
    raise(SIGTERM);
    EXPECT_EQ(SIGTERM, pendingSignal());
    EXPECT_EQ(SIGTERM, ending.wait());
    EXPECT_EQ(0, pendingSignal());
}

TEST(SignalCatchers, WaitingOneIsToldOfTheEnd) {
    SignalCatcher ending({SIGTERM});
    int told = 0;
    std::thread waiting([&told] {
        SignalCatcher other({SIGUSR1});
        told = other.wait();
    });
    raise(SIGTERM);
    waiting.join();
    EXPECT_EQ(SIGTERM, told);
}

// The handler may be on its way in one thread while another one gives its catcher up.
TEST(SignalCatchers, AreGivenUpWhileTheirHandlerExecutes) {
    struct sigaction ignored = {}, before = {};
    ignored.sa_handler = [](int) {};
    ASSERT_EQ(0, sigaction(SIGUSR1, &ignored, &before));
    constexpr int kTimes = 200;
    std::atomic<int> made{0}, raised{0};
    std::thread raising([&] {
        for (int i = 1; i <= kTimes; ++i) {
            while (made != i) std::this_thread::yield();
            raise(SIGUSR1);
            raised = i;
        }
    });
    for (int i = 1; i <= kTimes; ++i) {
        {
            const auto catcher = std::make_unique<SignalCatcher>(std::initializer_list<int>{SIGUSR1});
            made = i;
            for (volatile int spin = 0; spin < i * 10; spin = spin + 1) {
            }
        }
        while (raised != i) std::this_thread::yield();
    }
    raising.join();
    sigaction(SIGUSR1, &before, nullptr);
}

}  // namespace
