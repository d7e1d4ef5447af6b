#include "my-pkg-topics.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

// No node is needed: the harness writes and reads messages at the ports.
TEST(My_pkgTopics, AnswersEachCommand) {
    robots::My_pkgTopics component("component");
    RTT::extras::ComponentHarness harness(component);
    auto& command = harness.input<std_msgs::Float64>("command");
    auto& state = harness.output<std_msgs::Float64>("state");
    ASSERT_TRUE(harness.start());

    std_msgs::Float64 value;
    value.data = 1.5;
    command.write(value);
    harness.step();

    EXPECT_EQ(state.last().data, 1.5);
}
