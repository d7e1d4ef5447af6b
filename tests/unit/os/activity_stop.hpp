// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What stop() promises for every kind of activity. `action` is what the runner of the activity does when it is executed,
// `execute` what a user calls for that in a thread of its own; it is empty if the activity has its own thread.
#ifndef OROFORGE_TESTS_UNIT_OS_ACTIVITY_STOP_HPP
#define OROFORGE_TESTS_UNIT_OS_ACTIVITY_STOP_HPP

#include "os_test.hpp"

#include <rtt/base/ActivityInterface.hpp>

#include <thread>

namespace oroforge::test {

/** Nothing is executed any more after stop(), even if it returns false because the runner itself was faster. */
inline void expectStopWaitsForOneThatStoppedItself(RTT::base::ActivityInterface& a, std::function<void()>& action,
                                                   const std::function<void()>& execute) {
    std::atomic<bool> stopped{false}, left{false};
    action = [&] {
        stopped = a.stop();
        usleep(30000);
        left = true;
    };
    ASSERT_TRUE(a.start());
    std::thread user(execute);
    ASSERT_TRUE(eventually([&] { return stopped.load(); }));
    EXPECT_FALSE(a.stop());
    EXPECT_TRUE(left);
    user.join();
    action = nullptr;  // it refers to variables that end here
}

/** A thread that finds it inactive may touch what its runner uses. */
inline void expectActiveUntilStopHasWaited(RTT::base::ActivityInterface& a, std::function<void()>& action,
                                           const std::function<bool()>& stopHasBegun,
                                           const std::function<void()>& execute = nullptr) {
    std::atomic<bool> inside{false}, active{false};
    action = [&] {
        inside = true;
        EXPECT_TRUE(eventually(stopHasBegun));
        active = a.isActive();
    };
    ASSERT_TRUE(a.start());
    std::thread user([&] {
        if (execute) execute();
    });
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_TRUE(a.stop());
    EXPECT_FALSE(a.isActive());
    EXPECT_TRUE(active);
    user.join();
    action = nullptr;  // it refers to variables that end here
}

}  // namespace oroforge::test
#endif
