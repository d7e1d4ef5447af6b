#include "Controller.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

namespace {

TEST(Controller, CanBeMade) {
    tank::Controller component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), tank::Controller::PreOperational);
}

TEST(Controller, HasItsPorts) {
    tank::Controller component("component");

    EXPECT_NE(dynamic_cast<RTT::InputPort<tank::LevelSample>*>(component.getPort("level")), nullptr);
    EXPECT_NE(dynamic_cast<RTT::OutputPort<double>*>(component.getPort("valve")), nullptr);
}

TEST(Controller, HasItsProperties) {
    tank::Controller component("component");

    auto* gain_ = dynamic_cast<RTT::Property<double>*>(component.getProperty("gain"));
    ASSERT_NE(gain_, nullptr);
    EXPECT_EQ(gain_->get(), 1.5);
}

TEST(Controller, HasItsAttributes) {
    tank::Controller component("component");

    EXPECT_NE(component.getAttribute("cycles"), nullptr);
}

TEST(Controller, HasItsOperations) {
    tank::Controller component("component");

    EXPECT_TRUE(component.provides()->hasOperation("reset"));
}

TEST(Controller, RunsStepByStep) {
    tank::Controller component("component");
    RTT::extras::ComponentHarness harness(component, 0.01);
    harness.input<tank::LevelSample>("level");
    harness.output<double>("valve");

    ASSERT_TRUE(harness.start());
    harness.step();
    EXPECT_TRUE(component.isRunning());

    // The probes above return what the test goes on with: .write(sample) of an input, .last() and .all() of an output;
    // harness.call<double(int)>("operation", 1) calls, harness.step(0.5) lets half a second pass.

    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), tank::Controller::PreOperational);
}

}  // namespace
