// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "service_fixture.hpp"

#include <rtt/SendHandle.hpp>
#include <rtt/internal/DataSources.hpp>

#include <ros/ros.h>

using namespace service_test;
using RTT::SendHandle;

namespace {

/** Services of roscpp in this process. */
class Servers {
public:
    bool isOn = false;
    int calls = 0;

private:
    bool set(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
        ++calls;
        isOn = request.data != 0;
        response.success = isOn;
        response.message = isOn ? "high" : "low";
        return true;
    }
    bool ask(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
        ++calls;
        response.success = isOn;
        response.message = "asked";
        return true;
    }
    bool poke(std_srvs::Empty::Request&, std_srvs::Empty::Response&) { return ++calls < 100; }
    ros::NodeHandle node_;
    ros::ServiceServer set_ = node_.advertiseService("/set", &Servers::set, this);
    ros::ServiceServer ask_ = node_.advertiseService("/ask", &Servers::ask, this);
    ros::ServiceServer poke_ = node_.advertiseService("/poke", &Servers::poke, this);
};

class ServiceClientTest : public ServiceTest {
protected:
    Servers servers;
};

}  // namespace

TEST_F(ServiceClientTest, EachSignatureCalls) {
    std_srvs::SetBool call;
    call.request.data = true;
    EXPECT_FALSE(pump->standard.ready());
    ASSERT_TRUE(pump->services->connect("away.standard", "/set", "std_srvs/SetBool"));
    EXPECT_TRUE(pump->standard.ready());
    EXPECT_TRUE(pump->standard(call.request, call.response));
    EXPECT_EQ("high", call.response.message);
    EXPECT_TRUE(call.response.success);

    std::string text;
    ASSERT_TRUE(pump->services->connect("withMessage", "/set", "std_srvs/SetBool"));
    EXPECT_FALSE(pump->withMessage(false, text));
    EXPECT_EQ("low", text);
    ASSERT_TRUE(pump->services->connect("plain", "/set", "std_srvs/SetBool"));
    EXPECT_TRUE(pump->plain(true));
    ASSERT_TRUE(pump->services->connect("asText", "/set", "std_srvs/SetBool"));
    EXPECT_EQ("low", pump->asText(false));
    ASSERT_TRUE(pump->services->connect("away.quiet", "/set", "std_srvs/SetBool"));
    pump->quiet(true);
    EXPECT_TRUE(servers.isOn);

    ASSERT_TRUE(pump->services->connect("trigger", "/ask", "std_srvs/Trigger"));
    EXPECT_TRUE(pump->trigger(text));
    EXPECT_EQ("asked", text);
    ASSERT_TRUE(pump->services->connect("ping", "/ask", "std_srvs/Trigger"));
    EXPECT_TRUE(pump->ping());
    ASSERT_TRUE(pump->services->connect("poke", "/poke", "std_srvs/Empty"));
    pump->poke();
    EXPECT_EQ(8, servers.calls);
    servers.calls = 1000;
    ASSERT_TRUE(pump->services->connect("ping", "/poke", "std_srvs/Empty"));
    const LogText log;
    EXPECT_FALSE(pump->ping());
    EXPECT_TRUE(log.has("the server refused the call")) << log.text();
}

TEST_F(ServiceClientTest, AfterDisconnectNothingIsReady) {
    ASSERT_TRUE(pump->services->connect("plain", "/set", "std_srvs/SetBool"));
    OperationCaller<bool(bool)> copy = pump->plain;
    EXPECT_TRUE(copy(true));
    ASSERT_TRUE(pump->services->disconnect("/set"));
    EXPECT_FALSE(pump->plain.ready());
    EXPECT_FALSE(copy.ready());
    EXPECT_FALSE(copy(true));
    EXPECT_FALSE(pump->plain(true));
    EXPECT_EQ(RTT::SendFailure, pump->plain.send(true).collect());
    EXPECT_EQ(1, servers.calls);
    ASSERT_TRUE(pump->services->connect("plain", "/set", "std_srvs/SetBool"));
    EXPECT_TRUE(pump->plain(true));
}

TEST_F(ServiceClientTest, ACallerOfAnotherSignatureIsRefused) {
    const LogText log;
    EXPECT_FALSE(pump->services->connect("away.odd", "/set", "std_srvs/SetBool"));
    EXPECT_TRUE(log.has("bool (/std_srvs/SetBoolRequest const&, /std_srvs/SetBoolResponse &)")) << log.text();
    EXPECT_TRUE(log.has("double (int)")) << log.text();
    EXPECT_TRUE(log.has("operation caller 'odd' of component 'pump' cannot use service '/set'")) << log.text();
    EXPECT_FALSE(pump->odd.ready());
    EXPECT_FALSE(pump->services->connect("away.standard", "/ask", "std_srvs/Trigger"));
    EXPECT_TRUE(log.has("import rtt_std_srvs")) << log.text();
    EXPECT_FALSE(pump->services->disconnect("/set"));
}

TEST_F(ServiceClientTest, SentCallsAreCollected) {
    ASSERT_TRUE(pump->services->connect("away.standard", "/set", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("withMessage", "/set", "std_srvs/SetBool"));
    std_srvs::SetBool call;
    call.request.data = true;
    SendHandle<bool(std_srvs::SetBoolRequest&, std_srvs::SetBoolResponse&)> handle =
        pump->standard.send(call.request, call.response);
    bool result = false;
    ASSERT_EQ(RTT::SendSuccess, handle.collect(result, call.request, call.response));
    EXPECT_TRUE(result);
    EXPECT_EQ("high", call.response.message);

    std::string text;
    SendHandle<bool(bool, std::string&)> other = pump->withMessage.send(true, text);
    RTT::SendStatus status = RTT::SendNotReady;
    for (int i = 0; i != 500 && status == RTT::SendNotReady; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        status = other.collectIfDone(result, text);
    }
    EXPECT_EQ(RTT::SendSuccess, status);
    EXPECT_EQ("high", text);
    EXPECT_EQ(RTT::SendSuccess, pump->withMessage.send(false, text).collect());
}

TEST_F(ServiceClientTest, AnotherServiceReplacesTheFirst) {
    ASSERT_TRUE(pump->services->connect("ping", "/ask", "std_srvs/Trigger"));
    EXPECT_FALSE(pump->ping());
    ASSERT_TRUE(pump->services->connect("ping", "/poke", "std_srvs/Empty"));
    EXPECT_TRUE(pump->ping());
    EXPECT_FALSE(pump->services->disconnect("/ask"));
    EXPECT_TRUE(pump->services->disconnect("/poke"));
}

TEST_F(ServiceTest, APythonServerAnswers) {
    const auto server = startServer("0");
    ASSERT_TRUE(pump->services->connect("away.standard", "/switch", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("withMessage", "switch", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("ping", "/broken", "std_srvs/Trigger"));
    std_srvs::SetBool call;
    call.request.data = true;
    EXPECT_TRUE(pump->standard(call.request, call.response));
    EXPECT_EQ("on", call.response.message);
    std::string text;
    EXPECT_FALSE(pump->withMessage(false, text));
    EXPECT_EQ("off", text);
    EXPECT_FALSE(pump->ping());
    EXPECT_TRUE(pump->services->disconnect("/switch"));
    EXPECT_FALSE(pump->standard.ready());
    EXPECT_FALSE(pump->withMessage.ready());
}
