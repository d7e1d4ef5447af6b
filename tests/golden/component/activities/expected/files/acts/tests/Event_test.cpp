#include "Event.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Event, CanBeMade) {
    acts::Event component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), acts::Event::Stopped);
}

TEST(Event, ConfiguresStartsAndStops) {
    acts::Event component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), acts::Event::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), acts::Event::PreOperational);
}

}  // namespace
