#include "Sink.hpp"

#include <gtest/gtest.h>

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

TEST(Sink, ConfiguresStartsAndStops) {
    pair::Sink component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), pair::Sink::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), pair::Sink::PreOperational);
}

}  // namespace
