// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OS_MESSAGE_RUNNER_HPP
#define OROFORGE_TESTS_UNIT_OS_MESSAGE_RUNNER_HPP

#include "os_test.hpp"

#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/DisposableInterface.hpp>

#include <deque>

namespace oroforge::test {

/** What an engine does with messages. */
struct MessageRunner : CountingRunner {
    std::mutex mutex;
    std::deque<RTT::base::DisposableInterface*> queue;

    ~MessageRunner() override {
        for (RTT::base::DisposableInterface* message : queue) message->dispose();
    }
    bool process(RTT::base::DisposableInterface* message) override {
        {
            std::lock_guard<std::mutex> lock(mutex);
            queue.push_back(message);
        }
        return getActivity()->trigger();
    }
    void work(WorkReason) override {
        while (RTT::base::DisposableInterface* message = take()) message->executeAndDispose();
    }
    bool breakLoop() override { return true; }
    RTT::base::DisposableInterface* take() {
        std::lock_guard<std::mutex> lock(mutex);
        if (queue.empty()) return nullptr;
        RTT::base::DisposableInterface* const first = queue.front();
        queue.pop_front();
        return first;
    }
};

}  // namespace oroforge::test
#endif
