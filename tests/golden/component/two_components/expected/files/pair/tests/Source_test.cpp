#include "Source.hpp"

#include <gtest/gtest.h>

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

TEST(Source, ConfiguresStartsAndStops) {
    pair::Source component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), pair::Source::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), pair::Source::PreOperational);
}

}  // namespace
