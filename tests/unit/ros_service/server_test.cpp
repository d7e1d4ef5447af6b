// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "service_fixture.hpp"

#include <rtt/internal/GlobalEngine.hpp>

#include <ros/ros.h>

using namespace service_test;

namespace {

/** What a server answered: "1 text", or "failed". */
std::string setBool(const std::string& service, bool on) {
    std_srvs::SetBool call;
    call.request.data = on;
    if (!ros::service::call(service, call)) return "failed";
    return std::to_string(call.response.success) + " " + call.response.message;
}
std::string trigger(const std::string& service) {
    std_srvs::Trigger call;
    if (!ros::service::call(service, call)) return "failed";
    return std::to_string(call.response.success) + " " + call.response.message;
}
bool empty(const std::string& service) {
    std_srvs::Empty call;
    return ros::service::call(service, call);
}

}  // namespace

TEST_F(ServiceTest, AnOperationIsCalledByTheToolsOfRos) {
    ASSERT_TRUE(pump->services->connect("own.standard", "/pump/set", "std_srvs/SetBool"));
    EXPECT_NE(std::string::npos, listed().find("/pump/set\n"));
    const Outcome called = RosMaster::tool({"rosservice", "call", "/pump/set", "true"});
    EXPECT_EQ("success: True\nmessage: \"pumping\"\n", called.out) << called.err;
    EXPECT_TRUE(pump->isOn);
    EXPECT_EQ("std_srvs/SetBool\n", RosMaster::tool({"rosservice", "type", "/pump/set"}).out);
    ASSERT_TRUE(pump->services->disconnect("/pump/set"));
    EXPECT_EQ(std::string::npos, listed().find("/pump/set"));
    EXPECT_FALSE(pump->services->disconnect("/pump/set"));
}

TEST_F(ServiceTest, EachSignatureOfSetBoolAnswers) {
    ASSERT_TRUE(pump->services->connect("client", "/a", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("setMessage", "/b", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("setFlag", "/c", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("setText", "/d", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("setSilent", "/e", "std_srvs/SetBool"));
    EXPECT_EQ("1 pumping", setBool("/a", true));
    EXPECT_EQ("0 ", setBool("/a", false));
    EXPECT_EQ("1 up", setBool("/b", true));
    EXPECT_EQ("0 down", setBool("/b", false));
    EXPECT_EQ("0 ", setBool("/c", true));
    EXPECT_EQ("1 ", setBool("/c", false));
    EXPECT_EQ("1 yes", setBool("/d", true));
    EXPECT_EQ("1 no", setBool("/d", false));
    EXPECT_EQ("1 ", setBool("/e", true));
    EXPECT_TRUE(pump->isOn);
}

TEST_F(ServiceTest, EachSignatureOfTriggerAndEmptyAnswers) {
    ASSERT_TRUE(pump->services->connect("report", "/a", "std_srvs/Trigger"));
    ASSERT_TRUE(pump->services->connect("ask", "/b", "std_srvs/Trigger"));
    ASSERT_TRUE(pump->services->connect("tell", "/c", "std_srvs/Trigger"));
    ASSERT_TRUE(pump->services->connect("ask", "/d", "std_srvs/Empty"));
    ASSERT_TRUE(pump->services->connect("flip", "/e", "std_srvs/Empty"));
    EXPECT_EQ("0 off", trigger("/a"));
    EXPECT_EQ("0 ", trigger("/b"));
    EXPECT_EQ("1 told", trigger("/c"));
    EXPECT_FALSE(empty("/d"));
    EXPECT_TRUE(empty("/e"));
    EXPECT_TRUE(empty("/d"));
    EXPECT_EQ("1 on", trigger("/a"));
}

TEST_F(ServiceTest, OwnThreadRunsInTheComponentAndClientThreadInASpinner) {
    ASSERT_TRUE(pump->services->connect("own.standard", "~own", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("client", "/client", "std_srvs/SetBool"));
    OperationCaller<void()> flip(pump->getOperation("flip"), RTT::internal::GlobalEngine::Instance());
    flip();
    const std::thread::id component = pump->thread;
    EXPECT_NE(std::this_thread::get_id(), component);
    pump->thread = {};
    EXPECT_EQ("1 pumping", setBool("/pumps/own", true));
    EXPECT_EQ(component, pump->thread);
    EXPECT_EQ("1 pumping", setBool("/client", true));
    EXPECT_NE(component, pump->thread);
    EXPECT_TRUE(pump->services->disconnect("~own"));
}

TEST_F(ServiceTest, AFailedConnectLeavesNothing) {
    const LogText log;
    EXPECT_FALSE(pump->services->connect("half", "/half", "std_srvs/SetBool"));
    EXPECT_TRUE(
        log.has("its signature is double(int), expected bool(/std_srvs/SetBoolRequest const&, "
                "/std_srvs/SetBoolResponse &), or bool(bool, string &), or bool(bool), or string(bool), or "
                "void(bool)"))
        << log.text();
    EXPECT_FALSE(pump->services->connect("tank.half", "/half", "std_srvs/SetBool"));
    EXPECT_TRUE(log.has("'pump' neither requires nor provides"));
    EXPECT_FALSE(pump->services->connect("flip", "/half", "ship_msgs/Sail"));
    EXPECT_TRUE(log.has("import rtt_ship_msgs"));
    EXPECT_FALSE(pump->services->connect("flip", "/half", "Sail"));
    EXPECT_FALSE(pump->services->connect("flip", "/ha lf", "std_srvs/Empty"));
    EXPECT_TRUE(log.has("the name is malformed: "));
    EXPECT_FALSE(pump->services->connect("flip", "", "std_srvs/Empty"));
    EXPECT_TRUE(log.has("the name is malformed: it is empty")) << log.text();
    EXPECT_FALSE(pump->services->connect("flip", "a/", "std_srvs/Empty"));
    EXPECT_TRUE(log.has("the name is malformed: it ends with a slash")) << log.text();
    EXPECT_FALSE(pump->services->connect("flip", "~", "std_srvs/Empty"));
    EXPECT_TRUE(log.has("such as ~x")) << log.text();
    EXPECT_FALSE(pump->services->connect("ping", "~~x", "std_srvs/Empty"));
    EXPECT_FALSE(pump->services->connect("ping", "1x", "std_srvs/Empty"));
    EXPECT_FALSE(pump->services->connect("half", "/half", "std_srvs/Trigger"));
    EXPECT_TRUE(log.has("import rtt_std_srvs"));
    EXPECT_FALSE(ros::service::exists("/half", false));
    ASSERT_TRUE(pump->services->connect("flip", "/half", "std_srvs/Empty"));
    EXPECT_FALSE(pump->services->connect("ask", "/half", "std_srvs/Empty"));
    EXPECT_TRUE(log.has("offers a service of that name already"));
    EXPECT_TRUE(empty("/half"));
    pump->services->disconnectAll();
    EXPECT_FALSE(ros::service::exists("/half", false));
}

TEST_F(ServiceTest, FailuresReachTheClientAsTexts) {
    ASSERT_TRUE(pump->services->connect("fails", "/fails", "std_srvs/Empty"));
    ASSERT_TRUE(pump->services->connect("ask", "/ask", "std_srvs/Empty"));
    Outcome called = RosMaster::tool({"rosservice", "call", "/fails"});
    EXPECT_NE(std::string::npos, (called.out + called.err).find("operation 'fails' of component 'pump': no water"))
        << called.out << called.err;
    called = RosMaster::tool({"rosservice", "call", "/ask"});
    EXPECT_NE(std::string::npos,
              (called.out + called.err).find("operation 'ask' of component 'pump': it returned false"))
        << called.out << called.err;
}

TEST_F(ServiceTest, AThousandConnectionsComeAndGo) {
    for (int i = 0; i != 1000; ++i) {
        ASSERT_TRUE(pump->services->connect("flip", "/flip", "std_srvs/Empty"));
        if (i % 100 == 0) {
            EXPECT_TRUE(empty("/flip"));
        }
        ASSERT_TRUE(pump->services->disconnect("flip"));  // "/flip" as well
    }
    EXPECT_FALSE(ros::service::exists("/flip", false));
}
