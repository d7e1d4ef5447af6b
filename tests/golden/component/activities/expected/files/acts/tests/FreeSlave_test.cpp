#include "FreeSlave.hpp"

#include <gtest/gtest.h>

namespace {

TEST(FreeSlave, CanBeMade) {
    acts::FreeSlave component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), acts::FreeSlave::Stopped);
}

TEST(FreeSlave, ConfiguresStartsAndStops) {
    acts::FreeSlave component("component");

    ASSERT_TRUE(component.configure());
    EXPECT_EQ(component.getTaskState(), acts::FreeSlave::Stopped);
    ASSERT_TRUE(component.start());
    EXPECT_TRUE(component.isRunning());
    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), acts::FreeSlave::PreOperational);
}

}  // namespace
