// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OS_OS_TEST_HPP
#define OROFORGE_TESTS_UNIT_OS_OS_TEST_HPP

#include <rtt/base/RunnableInterface.hpp>
#include <rtt/os/fosi.h>

#include <atomic>
#include <functional>
#include <gtest/gtest.h>
#include <unistd.h>

namespace oroforge::test {

/** Waits, generously, until something becomes true. */
template <class Predicate>
bool eventually(Predicate&& predicate, double seconds = 20.0) {
    const long long end = rtos_get_time_ns() + static_cast<long long>(seconds * 1e9);
    while (!predicate()) {
        if (rtos_get_time_ns() > end) return false;
        usleep(200);
    }
    return true;
}

/** Counts every call. Each action, if set, runs in the call of the same name. */
struct CountingRunner : RTT::base::RunnableInterface {
    std::atomic<int> initialized{0}, steps{0}, loops{0}, finalized{0}, breaks{0};
    std::atomic<int> timeouts{0}, triggers{0};
    std::atomic<bool> initializeResult{true}, breakResult{true}, hasWorkResult{false};
    std::function<void()> onStep, onLoop, onFinalize;
    std::function<void(WorkReason)> onWork;

    bool initialize() override {
        ++initialized;
        return initializeResult;
    }
    void step() override {
        ++steps;
        if (onStep) onStep();
    }
    void loop() override {
        ++loops;
        if (onLoop) onLoop();
    }
    bool breakLoop() override {
        ++breaks;
        return breakResult;
    }
    void finalize() override {
        ++finalized;
        if (onFinalize) onFinalize();
    }
    bool hasWork() override { return hasWorkResult; }
    void work(WorkReason reason) override {
        reason == Trigger ? ++triggers : ++timeouts;
        if (onWork) onWork(reason);
    }
};

}  // namespace oroforge::test
#endif
