// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components of a runtime that is built with ORO_ACT_DEFAULT_SEQUENTIAL. This program has TaskContext.cpp in itself, built so.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/extras/SequentialActivity.hpp>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

// AddressSanitizer reports every global of TaskContext.cpp that the library has, too; here that is intended.
extern "C" const char* __asan_default_options() { return "detect_odr_violation=0"; }

namespace {

TEST(DefaultSequential, ComponentBeginsWithoutAThread) {
    Probe c;
    EXPECT_TRUE(c.getActivity<extras::SequentialActivity>());
    EXPECT_TRUE(c.isActive());
    ASSERT_TRUE(c.start());
    EXPECT_EQ(c.updates, 1) << "executed by the thread that started it";
    EXPECT_TRUE(c.trigger());
    EXPECT_EQ(c.updates, 2);
    EXPECT_TRUE(c.stop());
}

TEST(DefaultSequential, ActivityCanBeChangedFromMainAndBack) {
    Probe c;
    EXPECT_TRUE(c.setActivity(new Activity(ORO_SCHED_OTHER, 0, 0.001)));
    ASSERT_TRUE(c.start());
    EXPECT_TRUE(eventually([&] { return c.updates > 2; }));
    ASSERT_TRUE(c.stop());
    EXPECT_TRUE(c.setActivity(nullptr));
    EXPECT_TRUE(c.getActivity<extras::SequentialActivity>());
}

// An operation that the component's thread executes does not meet its updateHook(), though both have the thread of main.
TEST(DefaultSequential, OwnThreadOperationsExcludeUpdateHook) {
    Probe c, caller("caller");
    std::atomic<bool> inside{false}, together{false};
    const auto alone = [&] {
        together = together || inside.exchange(true);
        usleep(50);
        inside = false;
    };
    c.onUpdate = alone;
    c.addOperation("op", alone, OwnThread);
    ASSERT_TRUE(c.start());
    std::thread other([&] {
        for (int i = 0; i != 200; ++i) c.trigger();
    });
    OperationCaller<void()> op(c.getOperation("op"), caller.engine());
    for (int i = 0; i != 200; ++i) op();
    other.join();
    EXPECT_FALSE(together);
}

}  // namespace
