#include "Slave.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Slave, CanBeMade) {
    acts::Slave component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), acts::Slave::Stopped);
}

TEST(Slave, ConfiguresStartsAndStops) {
    acts::Slave component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), acts::Slave::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), acts::Slave::PreOperational);
}

}  // namespace
