#include "Controller.hpp"

#include <gtest/gtest.h>

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

TEST(Controller, ConfiguresStartsAndStops) {
    tank::Controller component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), tank::Controller::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), tank::Controller::PreOperational);
}

}  // namespace
