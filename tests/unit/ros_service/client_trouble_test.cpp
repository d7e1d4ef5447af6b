// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "service_fixture.hpp"

#include <rtt/SendHandle.hpp>
#include <rtt/internal/DataSources.hpp>

#include <ros/ros.h>

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <thread>

using namespace service_test;

namespace {

typedef std::chrono::steady_clock Clock;
bool isSoon(Clock::time_point since) { return Clock::now() - since < std::chrono::seconds(10); }

/** A service of roscpp whose calls last until it is destroyed. */
class Stuck {
    struct State {
        std::atomic<bool> isIn{false}, isOver{false};
    };
    // roscpp does not wait for all calls when a service ends.
    const std::shared_ptr<State> state_ = std::make_shared<State>();

public:
    ~Stuck() { state_->isOver = true; }
    std::atomic<bool>& isIn = state_->isIn;

private:
    typedef std_srvs::Trigger::Request Request;
    typedef std_srvs::Trigger::Response Response;
    static boost::function<bool(Request&, Response&)> waiting(std::shared_ptr<State> state) {
        return [state](Request&, Response&) {
            state->isIn = true;
            while (!state->isOver) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return true;
        };
    }
    ros::NodeHandle node_;
    ros::ServiceServer server_ = node_.advertiseService("/stuck", waiting(state_));
};

}  // namespace

TEST_F(ServiceTest, AServerThatIsAwayIsReportedOnce) {
    ASSERT_TRUE(pump->services->connect("trigger", "/nowhere", "std_srvs/Trigger"));
    const LogText log;
    std::string text = "old";
    EXPECT_FALSE(pump->trigger(text));
    EXPECT_TRUE(log.has("no node offers it")) << log.text();
    const std::size_t size = log.text().size();
    EXPECT_FALSE(pump->trigger(text));
    EXPECT_EQ(size, log.text().size());
    bool result = true;
    EXPECT_EQ(RTT::CollectFailure, pump->trigger.send(text).collect(result, text));
    pump->addOperation("report2", std::function<bool()>([] { return true; }));
    ASSERT_TRUE(pump->services->connect("report2", "/nowhere", "std_srvs/Trigger"));
    EXPECT_TRUE(pump->trigger(text));
}

TEST_F(ServiceTest, AServerThatEndsIsFoundAgain) {
    auto server = startServer("30");
    ASSERT_TRUE(pump->services->connect("plain", "/switch", "std_srvs/SetBool"));
    ASSERT_TRUE(pump->services->connect("trigger", "/slow", "std_srvs/Trigger"));
    EXPECT_TRUE(pump->plain(true));
    std::string text;
    std::thread killer([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        server->send(SIGKILL);
    });
    const auto begin = Clock::now();
    EXPECT_FALSE(pump->trigger(text));  // the server dies meanwhile
    EXPECT_TRUE(isSoon(begin));
    killer.join();
    EXPECT_FALSE(pump->plain(true));
    server = startServer("0");
    EXPECT_TRUE(pump->plain(true));
    EXPECT_TRUE(pump->trigger(text));
    EXPECT_EQ("late", text);
}

TEST_F(ServiceTest, AServerOfAnotherVersionIsReported) {
    pump->addOperation("yes", std::function<bool()>([] { return true; }));
    ASSERT_TRUE(pump->services->connect("yes", "/yes", "std_srvs/Empty"));
    ASSERT_TRUE(pump->services->connect("trigger", "/yes", "std_srvs/Trigger"));
    const LogText log;
    std::string text;
    EXPECT_FALSE(pump->trigger(text));
    EXPECT_TRUE(log.has("another version of the type")) << log.text();
}

TEST_F(ServiceTest, ATimeOutEndsCalls) {
    Stuck server;
    RTT::Property<double> timeout = pump->provides("rosservice")->getProperty("timeout");
    ASSERT_TRUE(timeout.ready());
    timeout.set(0.1);
    ASSERT_TRUE(pump->services->connect("trigger", "/stuck", "std_srvs/Trigger"));
    const LogText log;
    std::string text;
    const auto begin = Clock::now();
    EXPECT_FALSE(pump->trigger(text));
    bool result = true;
    EXPECT_EQ(RTT::CollectFailure, pump->trigger.send(text).collect(result, text));
    EXPECT_TRUE(isSoon(begin));
    EXPECT_TRUE(log.has("no response within 0.1")) << log.text();
}

TEST_F(ServiceTest, ARequestThatIsLateInTheQueueLeavesTheOthers) {
    std::atomic<int> calls{0};
    const boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> slow =
        [&](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
            ++calls;
            std::this_thread::sleep_for(std::chrono::milliseconds(600));
            return (response.success = true);
        };
    ros::ServiceServer server = ros::NodeHandle().advertiseService("/late", slow);
    RTT::Property<double> timeout = pump->provides("rosservice")->getProperty("timeout");
    timeout.set(0.9);
    ASSERT_TRUE(pump->services->connect("ping", "/late", "std_srvs/Trigger"));
    RTT::SendHandle<bool()> first = pump->ping.send(), second = pump->ping.send();
    const LogText log;
    EXPECT_FALSE(pump->ping());
    EXPECT_TRUE(log.has("no response within 0.9")) << log.text();
    bool result = false;
    EXPECT_EQ(RTT::SendSuccess, first.collect(result));
    EXPECT_TRUE(result);
    result = false;
    EXPECT_EQ(RTT::SendSuccess, second.collect(result));
    EXPECT_TRUE(result);
    EXPECT_TRUE(pump->ping());
    EXPECT_EQ(3, calls);
}

TEST_F(ServiceTest, ACallThatNobodyCollectsStopsOthersForItsTimeOnly) {
    Stuck server;
    RTT::Property<double> timeout = pump->provides("rosservice")->getProperty("timeout");
    timeout.set(0.3);
    ASSERT_TRUE(pump->services->connect("ping", "/stuck", "std_srvs/Trigger"));
    (void)pump->ping.send();
    while (!server.isIn) std::this_thread::yield();
    server.isIn = false;
    for (int i = 0; i != 2; ++i) EXPECT_FALSE(pump->ping());
    EXPECT_TRUE(server.isIn);  // by a call that followed
}

TEST_F(ServiceTest, WithoutAThreadASentCallFails) {
    pump->addOperation("yes", std::function<bool()>([] { return true; }));
    ASSERT_TRUE(pump->services->connect("yes", "/yes", "std_srvs/Trigger"));
    ASSERT_TRUE(pump->services->connect("ping", "/yes", "std_srvs/Trigger"));
    pthread_attr_t before, huge;
    ASSERT_EQ(0, pthread_getattr_default_np(&before));
    ASSERT_EQ(0, pthread_attr_init(&huge));
    ASSERT_EQ(0, pthread_attr_setstacksize(&huge, std::size_t(1) << 50));
    ASSERT_EQ(0, pthread_setattr_default_np(&huge));
    const LogText log;
    RTT::SendHandle<bool()> handle;
    EXPECT_NO_THROW(handle = pump->ping.send());
    ASSERT_EQ(0, pthread_setattr_default_np(&before));
    EXPECT_EQ(RTT::SendFailure, handle.collect());
    EXPECT_TRUE(log.has("no thread to be had")) << log.text();
    EXPECT_EQ(RTT::SendSuccess, pump->ping.send().collect());
}

TEST_F(ServiceTest, DisconnectAndDestructionEndCalls) {
    Stuck server;
    ASSERT_TRUE(pump->services->connect("ping", "/stuck", "std_srvs/Trigger"));
    std::thread one([&] { EXPECT_FALSE(pump->ping()); });
    while (!server.isIn) std::this_thread::yield();
    const auto begin = Clock::now();
    EXPECT_TRUE(pump->services->disconnect("/stuck"));
    one.join();

    server.isIn = false;
    ASSERT_TRUE(pump->services->connect("ping", "/stuck", "std_srvs/Trigger"));
    OperationCaller<bool()> copy = pump->ping;
    bool result = true;
    RTT::SendHandle<bool()> handle = copy.send();
    std::thread other([&] { EXPECT_FALSE(copy()); });
    while (!server.isIn) std::this_thread::yield();
    pump.reset();
    other.join();
    EXPECT_EQ(RTT::CollectFailure, handle.collect(result));
    EXPECT_FALSE(copy.ready());
    EXPECT_TRUE(isSoon(begin));
}

TEST_F(ServiceTest, ClientsConnectAndDisconnectAThousandTimes) {
    pump->addOperation("yes", std::function<bool()>([] { return true; }));
    ASSERT_TRUE(pump->services->connect("yes", "/yes", "std_srvs/Trigger"));
    for (int i = 0; i != 1000; ++i) {
        ASSERT_TRUE(pump->services->connect("ping", "/yes", "std_srvs/Trigger"));
        if (i % 20 == 0) {
            EXPECT_TRUE(pump->ping());
        } else if (i % 20 == 10) {
            EXPECT_EQ(RTT::SendSuccess, pump->ping.send().collect());
        } else if (i % 20 == 15) {
            pump->services->disconnectAll();
            ASSERT_TRUE(pump->services->connect("yes", "/yes", "std_srvs/Trigger"));
        }
    }
}
