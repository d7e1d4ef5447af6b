#include "Client.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Client, CanBeMade) {
    services::Client component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), services::Client::Stopped);
}

TEST(Client, ConfiguresStartsAndStops) {
    services::Client component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), services::Client::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), services::Client::PreOperational);
}

}  // namespace
