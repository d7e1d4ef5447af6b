// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OS_OS_TEST_HPP
#define OROFORGE_TESTS_UNIT_OS_OS_TEST_HPP

#include <rtt/base/RunnableInterface.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/log_hook.hpp>

#include <atomic>
#include <functional>
#include <gtest/gtest.h>
#include <mutex>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

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
    std::atomic<int> timeouts{0}, triggers{0}, ios{0}, worked{0};
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
        ++(reason == Trigger ? triggers : reason == TimeOut ? timeouts : ios);
        if (onWork) onWork(reason);
        ++worked;
    }
};

/** Takes what the os layer and the activities log, from the first one on; each begins with nothing. */
class LogCapture {
public:
    LogCapture() {
        std::lock_guard<std::mutex> lock(mutex());
        lines().clear();
        RTT::os::setLogHook(&LogCapture::write);
    }
    /** Lines that begin with the level (2 Critical, 3 Error, 4 Warning, 5 Info) and contain the text. */
    static int count(int level, const std::string& text) {
        std::lock_guard<std::mutex> lock(mutex());
        int found = 0;
        for (const auto& line : lines())
            if (line.first == level && line.second.find(text) != std::string::npos) ++found;
        return found;
    }

private:
    static void write(int level, const char* module, std::string_view text) {
        std::lock_guard<std::mutex> lock(mutex());
        lines().emplace_back(level, std::string(module) + ": " + std::string(text));
    }
    static std::mutex& mutex() {
        static std::mutex& one = *new std::mutex;
        return one;
    }
    static std::vector<std::pair<int, std::string>>& lines() {
        static auto& all = *new std::vector<std::pair<int, std::string>>;
        return all;
    }
};

}  // namespace oroforge::test
#endif
