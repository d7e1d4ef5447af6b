// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A real-time thread may write to topics, whatever their subscribers do.
#include "node.hpp"

#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_roscomm/rostopic.h>
#include <support/real_time_trap.hpp>

#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <thread>

namespace {

using oroforge::test::ChildProcess;
using oroforge::test::Command;
using oroforge::test::expectRealTime;

TEST(RosRealTime, WritingIsRealTimeSafeWithASubscriberThatIsStopped) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    const ros_test::Node node;
    RTT::TaskContext component("c");
    RTT::OutputPort<double> number("number"), latest("latest");
    RTT::OutputPort<std::string> text("text");
    component.addPort(number);
    component.addPort(latest);
    component.addPort(text);
    const std::string sample(1000, 'x');
    text.setDataSample(sample);
    ASSERT_TRUE(number.createStream(rtt_roscomm::topicBuffer("/number", 10)));
    ASSERT_TRUE(latest.createStream(rtt_roscomm::topic("/latest")));
    ASSERT_TRUE(text.createStream(rtt_roscomm::topicBuffer("/text", 10)));
    Command command;
    command.program = "rostopic";
    command.arguments = {"echo", "/text"};
    ChildProcess echo(command);
    ASSERT_TRUE(ros_test::soon([&] {
        text.write(sample);
        return echo.waitForOutput("xxx", std::chrono::milliseconds(20));
    }));
    echo.send(SIGSTOP);
    for (int i = 0; i != 200; ++i) {
        expectRealTime([&] {
            number.write(i);
            latest.write(i);
            text.write(sample);
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    echo.send(SIGKILL);
}

}  // namespace
