#include "Slave.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

namespace {

TEST(Slave, CanBeMade) {
    acts::Slave component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), acts::Slave::Stopped);
}

TEST(Slave, RunsStepByStep) {
    acts::Slave component("component");
    RTT::extras::ComponentHarness harness(component, 0.1);

    ASSERT_TRUE(harness.start());
    harness.step();
    EXPECT_TRUE(component.isRunning());

    // The probes above return what the test goes on with: .write(sample) of an input, .last() and .all() of an output;
    // harness.call<double(int)>("operation", 1) calls, harness.step(0.5) lets half a second pass.

    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), acts::Slave::PreOperational);
}

}  // namespace
