// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <console/end_signals.hpp>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <thread>

#include <poll.h>

namespace {

using OCL::console::EndSignals;

std::atomic<int> others{0};

bool isTold(const EndSignals& signals) {
    pollfd descriptor = {signals.descriptor(), POLLIN, 0};
    return poll(&descriptor, 1, 0) == 1;
}

class EndSignalsTest : public testing::Test {
protected:
    EndSignalsTest() {
        others = 0;
        before_ = std::signal(SIGTERM, [](int) { ++others; });
    }
    ~EndSignalsTest() override { std::signal(SIGTERM, before_); }

private:
    void (*before_)(int);
};

TEST_F(EndSignalsTest, EachOfThemTellsOfItsOwnSignalsOnly) {
    for (int i = 0; i != 3; ++i) {
        EndSignals signals;
        EXPECT_FALSE(isTold(signals));
        std::raise(SIGTERM);
        EXPECT_TRUE(isTold(signals));
    }
    EXPECT_EQ(others, 0);
    std::raise(SIGTERM);
    EXPECT_EQ(others, 1);
}

TEST_F(EndSignalsTest, EndWhileTheirHandlerExecutesInAnotherThread) {
    constexpr int kRounds = 300;
    std::atomic<int> begun{0}, sent{0};
    std::thread sender([&] {
        for (int round = 1; round <= kRounds; ++round) {
            while (begun != round) std::this_thread::yield();
            std::raise(SIGTERM);  // ends the process if nobody takes it
            sent = round;
        }
    });
    for (int round = 1; round <= kRounds; ++round) {
        {
            EndSignals signals;
            begun = round;
            for (int i = round % 50; i != 0; --i) (void)isTold(signals);
        }
        while (sent != round) std::this_thread::yield();
    }
    sender.join();
    EXPECT_LE(others, kRounds);
}

}  // namespace
