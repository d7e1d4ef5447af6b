#include "Valve.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

namespace
{

TEST(Valve, CanBeMade)
{
    tank::Valve component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(),
              tank::Valve::Stopped);
}

TEST(Valve, HasItsOperations)
{
    tank::Valve component("component");

    EXPECT_TRUE(component.provides()->hasOperation("open"));
}

TEST(Valve, RunsStepByStep)
{
    tank::Valve component("component");
    RTT::extras::ComponentHarness harness(component);

    ASSERT_TRUE(harness.start());
    harness.step();
    EXPECT_TRUE(component.isRunning());

    // The probes above return what the test goes on with:
    // .write(sample) of an input, .last() and .all() of an
    // output; harness.call<double(int)>("operation", 1)
    // calls, harness.step(0.5) lets half a second pass.

    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(),
              tank::Valve::PreOperational);
}

} // namespace
