#include "Plain.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Plain, CanBeMade) {
    Plain component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), Plain::Stopped);
}

TEST(Plain, HasItsOperations) {
    Plain component("component");

    EXPECT_TRUE(component.provides()->hasOperation("go"));
    EXPECT_TRUE(component.provides()->hasOperation("pick"));
}

TEST(Plain, ConfiguresStartsAndStops) {
    Plain component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), Plain::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), Plain::PreOperational);
}

}  // namespace
