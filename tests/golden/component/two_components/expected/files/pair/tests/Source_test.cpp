#include "Source.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

namespace {

TEST(Source, CanBeMade) {
    pair::Source component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), pair::Source::Stopped);
}

TEST(Source, HasItsPorts) {
    pair::Source component("component");

    EXPECT_NE(dynamic_cast<RTT::OutputPort<double>*>(component.getPort("value")), nullptr);
}

TEST(Source, HasItsProperties) {
    pair::Source component("component");

    auto* step_ = dynamic_cast<RTT::Property<double>*>(component.getProperty("step"));
    ASSERT_NE(step_, nullptr);
    EXPECT_EQ(step_->get(), 1.0);
}

TEST(Source, RunsStepByStep) {
    pair::Source component("component");
    RTT::extras::ComponentHarness harness(component, 0.01);
    harness.output<double>("value");

    ASSERT_TRUE(harness.start());
    harness.step();
    EXPECT_TRUE(component.isRunning());

    // The probes above return what the test goes on with: .write(sample) of an input, .last() and .all() of an output;
    // harness.call<double(int)>("operation", 1) calls, harness.step(0.5) lets half a second pass.

    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), pair::Source::PreOperational);
}

}  // namespace
