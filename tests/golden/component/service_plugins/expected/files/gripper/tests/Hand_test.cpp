#include "Hand.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

namespace {

TEST(Hand, CanBeMade) {
    gripper::Hand component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), gripper::Hand::Stopped);
}

TEST(Hand, HasItsPorts) {
    gripper::Hand component("component");

    EXPECT_NE(dynamic_cast<RTT::OutputPort<double>*>(component.getPort("force")), nullptr);
    EXPECT_NE(dynamic_cast<RTT::InputPort<double>*>(component.provides("motion")->getPort("target")), nullptr);
}

TEST(Hand, HasItsProperties) {
    gripper::Hand component("component");

    auto* motion_speed_ = dynamic_cast<RTT::Property<double>*>(component.provides("motion")->getProperty("speed"));
    ASSERT_NE(motion_speed_, nullptr);
    EXPECT_EQ(motion_speed_->get(), 0.05);
}

TEST(Hand, HasItsAttributes) {
    gripper::Hand component("component");

    EXPECT_NE(component.getAttribute("fingers"), nullptr);
    EXPECT_NE(component.getAttribute("opening"), nullptr);
    EXPECT_NE(component.provides("motion")->provides("limits")->getAttribute("widest"), nullptr);
}

TEST(Hand, HasItsOperations) {
    gripper::Hand component("component");

    EXPECT_TRUE(component.provides("motion")->hasOperation("open"));
    EXPECT_TRUE(component.provides("motion")->provides("limits")->hasOperation("isInside"));
}

TEST(Hand, RunsStepByStep) {
    gripper::Hand component("component");
    RTT::extras::ComponentHarness harness(component);
    harness.output<double>("force");

    ASSERT_TRUE(harness.start());
    harness.step();
    EXPECT_TRUE(component.isRunning());

    // The probes above return what the test goes on with: .write(sample) of an input, .last() and .all() of an output;
    // harness.call<double(int)>("operation", 1) calls, harness.step(0.5) lets half a second pass.

    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), gripper::Hand::PreOperational);
}

}  // namespace
