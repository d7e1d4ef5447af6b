#include "my-pkg-component.hpp"

#include <gtest/gtest.h>

TEST(My_pkg, CanBeMade) {
    My_pkg component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), My_pkg::Stopped);
}

TEST(My_pkg, ConfiguresStartsAndStops) {
    My_pkg component("component");

    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), My_pkg::PreOperational);
}
