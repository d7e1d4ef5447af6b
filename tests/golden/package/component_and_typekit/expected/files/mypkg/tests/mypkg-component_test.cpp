#include "mypkg-component.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

TEST(Mypkg, CanBeMade) {
    Mypkg component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), Mypkg::Stopped);
}

TEST(Mypkg, RunsStepByStep) {
    Mypkg component("component");
    RTT::extras::ComponentHarness harness(component);

    ASSERT_TRUE(harness.start());
    harness.step();
    EXPECT_TRUE(component.isRunning());

    // harness.input<double>("in").write(1.0) and harness.output<double>("out").last() reach ports that it has,
    // harness.call<double>("operation", 1.0) its operations, and harness.step(0.5) lets half a second pass.

    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), Mypkg::PreOperational);
}
