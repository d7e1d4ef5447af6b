// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "message_script.hpp"

#include <ros/time.h>
#include <rtt_ros/primitives/message_typekit.hpp>

namespace ros_messages_test {
namespace {

using testing::HasSubstr;

class Primitives : public ScriptTest {
protected:
    Primitives() : ScriptTest("rtt_ros") {}
};

TEST_F(Primitives, namesOfMessagesAreThoseOfTheRuntimesTypes) {
    const auto types = RTT::types::Types();
    EXPECT_EQ(type("int8"), types->getTypeInfo<std::int8_t>());
    EXPECT_EQ(type("uint64"), types->getTypeInfo<std::uint64_t>());
    EXPECT_EQ(type("int32"), type("int"));
    EXPECT_EQ(type("uint32"), type("uint"));
    EXPECT_EQ(type("float32"), type("float"));
    EXPECT_EQ(type("float64"), type("double"));
    EXPECT_EQ(type("float64[]"), type("array"));
    for (const char* name : {"int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32",
                             "float64", "string", "time", "duration"}) {
        EXPECT_TRUE(type(name)) << name;
        EXPECT_TRUE(type(std::string(name) + "[]")) << name;
        EXPECT_TRUE(type("c" + std::string(name) + "[]")) << name;
    }
}

TEST_F(Primitives, timesFromSeconds) {
    EXPECT_TRUE(
        eval("var time t = 2.5\n"
             "count = t.nsec\n"
             "var duration d = duration(-0.25)\n"
             "number = 1.0 * d.sec\n"
             "var time[] all = time[](2)\n"
             "all[1].sec = 3\n"));
    EXPECT_EQ(count, 500000000);
    EXPECT_EQ(number, -1.0);
    EXPECT_FALSE(eval("t = time(-1.0)"));
    EXPECT_FALSE(eval("t = time(1e10)"));
    EXPECT_FALSE(eval("d = duration(1e10)"));
}

TEST_F(Primitives, constantsAreGlobals) {
    static constexpr rtt_ros::MessageConstant constants[] = {
        {"demo_msgs.State.LEFT", "int8", "-3"},      {"demo_msgs.State.MOST", "uint64", "18446744073709551615"},
        {"demo_msgs.State.NAME", "string", "a # b"}, {"demo_msgs.State.YES", "bool", "True"},
        {"demo_msgs.State.HALF", "float32", "0.5"},
    };
    rtt_ros::addConstants(constants, 5);
    rtt_ros::addConstants(constants, 5);
    EXPECT_TRUE(
        eval("text = demo_msgs.State.NAME\n"
             "number = demo_msgs.State.HALF\n"
             "var int8 left = demo_msgs.State.LEFT\n"
             "var uint8 yes = demo_msgs.State.YES\n"
             "var uint64 most = demo_msgs.State.MOST\n"
             "if (left == demo_msgs.State.LEFT) then count = 1\n"));
    EXPECT_EQ(text, "a # b");
    EXPECT_EQ(number, 0.5);
    EXPECT_EQ(count, 1);
    EXPECT_FALSE(eval("number = demo_msgs.State.NONE"));
}

TEST_F(Primitives, aMissingPackageIsNamed) {
    rtt_ros::needTypes("no_such_msgs");
    EXPECT_THAT(log.text(), HasSubstr("the types of no_such_msgs are missing"));
    EXPECT_THAT(log.text(), HasSubstr("import(\"rtt_no_such_msgs\")"));
}

}  // namespace
}  // namespace ros_messages_test
