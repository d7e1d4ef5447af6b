#include "Sequential.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Sequential, CanBeMade) {
    acts::Sequential component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), acts::Sequential::Stopped);
}

TEST(Sequential, ConfiguresStartsAndStops) {
    acts::Sequential component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), acts::Sequential::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), acts::Sequential::PreOperational);
}

}  // namespace
