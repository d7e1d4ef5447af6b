#include "mypkg-component.hpp"

#include <gtest/gtest.h>

TEST(Mypkg, CanBeMade) {
    Mypkg component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), Mypkg::Stopped);
}

TEST(Mypkg, ConfiguresStartsAndStops) {
    Mypkg component("component");

    ASSERT_TRUE(component.configure());
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), Mypkg::PreOperational);
}
