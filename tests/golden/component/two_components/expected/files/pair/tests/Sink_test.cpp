#include "Sink.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

namespace {

TEST(Sink, CanBeMade) {
    pair::Sink component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), pair::Sink::PreOperational);
}

TEST(Sink, HasItsPorts) {
    pair::Sink component("component");

    EXPECT_NE(dynamic_cast<RTT::InputPort<double>*>(component.getPort("value")), nullptr);
}

TEST(Sink, HasItsOperations) {
    pair::Sink component("component");

    EXPECT_TRUE(component.provides()->hasOperation("sum"));
}

TEST(Sink, RunsStepByStep) {
    pair::Sink component("component");
    RTT::extras::ComponentHarness harness(component);
    harness.input<double>("value");

    ASSERT_TRUE(harness.start());
    harness.step();
    EXPECT_TRUE(component.isRunning());

    // The probes above return what the test goes on with: .write(sample) of an input, .last() and .all() of an output;
    // harness.call<double(int)>("operation", 1) calls, harness.step(0.5) lets half a second pass.

    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), pair::Sink::PreOperational);
}

}  // namespace
