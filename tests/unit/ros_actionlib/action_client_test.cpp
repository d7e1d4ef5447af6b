// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Clients in components, and actions between components of one process.
#include "action_node.hpp"

#include <rtt_actionlib/rtt_simple_action_client.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace {

using namespace action_test;
using actionlib::TestAction;
using rtt_actionlib::RTTActionClient;
using rtt_actionlib::RTTSimpleActionClient;
using testing::HasSubstr;
typedef RTTSimpleActionClient<TestAction>::State State;

struct Boss : RTT::TaskContext {
    Boss() : TaskContext("boss"), client(provides("work")) {
        client.setActiveHook([this] { ++accepted; });
        client.setFeedbackHook([this](const actionlib::TestFeedbackConstPtr& news) { feedback = news->feedback; });
        client.setDoneHook([this](const State& state, const actionlib::TestResultConstPtr& result) {
            lastText = state.getText();
            lastResult = result ? result->result : -1;
            ++done;
        });
    }
    ~Boss() override { stop(); }
    RTTSimpleActionClient<TestAction> client;
    std::string lastText;
    int lastResult = 0;
    std::atomic<int> accepted{0}, feedback{0}, done{0};
};

class RosActionClient : public testing::Test {
protected:
    void run(bool overRos) {
        ASSERT_TRUE(boss.loadService("actionlib"));
        RTT::OperationCaller<bool(std::string, std::string)> connect(
            boss.provides("actionlib")->getOperation("connectSub"));
        if (overRos) {
            ASSERT_TRUE(connect("work", "/job"));
            ASSERT_TRUE(worker.server.server().bridge().createStream("/job"));
        } else {
            for (const char* name : {"_action_goal", "_action_cancel"})
                ASSERT_TRUE(boss.provides("work")->getPort(name)->connectTo(worker.ports()->getPort(name)));
            for (const char* name : {"_action_status", "_action_result", "_action_feedback"})
                ASSERT_TRUE(worker.ports()->getPort(name)->connectTo(boss.provides("work")->getPort(name)));
        }
        ASSERT_TRUE(boss.client.ready());
        ASSERT_TRUE(boss.start());
        EXPECT_FALSE(boss.client.isServerConnected());
        EXPECT_EQ(State::LOST, boss.client.getState().state_);
        EXPECT_FALSE(boss.client.cancelGoal());
        ASSERT_TRUE(worker.start());
        ASSERT_TRUE(soon([&] { return boss.client.isServerConnected(); }));
        useIt();
    }
    void useIt() {
        boss.client.sendGoal(Worker::goal(1));
        ASSERT_TRUE(soon([&] { return boss.done == 1; }));
        EXPECT_EQ(State::SUCCEEDED, boss.client.getState().state_);
        EXPECT_EQ(2, boss.client.getResult()->result);
        EXPECT_EQ(2, boss.lastResult);
        EXPECT_EQ("well done", boss.lastText);
        EXPECT_EQ(3, boss.feedback);
        boss.client.sendGoal(Worker::goal(5));
        ASSERT_TRUE(soon([&] { return boss.client.getState() == State::ACTIVE; }));
        EXPECT_EQ(nullptr, boss.client.getResult());
        EXPECT_TRUE(boss.client.cancelGoal());
        ASSERT_TRUE(soon([&] { return boss.done == 2; }));
        EXPECT_EQ(State::PREEMPTED, boss.client.getState().state_);
        EXPECT_EQ(7, boss.lastResult);
        EXPECT_FALSE(boss.client.cancelGoal());
    }
    Boss boss;
    Worker worker;
};

TEST_F(RosActionClient, AGoalSucceedsAndOneIsCancelledOverTopics) {
    const Node node;
    run(true);
    worker.ports()->getPort("_action_goal")->disconnect();
}

TEST_F(RosActionClient, PortsOfOneProcessNeedNoMaster) {
    addTypes();
    run(false);
}

TEST_F(RosActionClient, AGoalBeforeItsServerArrivesLater) {
    const Node node;
    ASSERT_TRUE(boss.client.client().bridge().createStream("/job"));
    ASSERT_TRUE(boss.start());
    boss.client.sendGoal(Worker::goal(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(State::PENDING, boss.client.getState().state_);
    ASSERT_TRUE(worker.server.server().bridge().createStream("/job"));
    ASSERT_TRUE(worker.start());
    EXPECT_TRUE(soon([&] { return boss.client.getState() == State::SUCCEEDED; }));
}

TEST_F(RosActionClient, ClientsOfManyThreadsAndGoals) {
    addTypes();
    run(false);
    std::vector<std::thread> threads;
    for (int i = 0; i != 4; ++i)
        threads.emplace_back([&, i] {
            for (int k = 0; k != 50; ++k) {
                boss.client.sendGoal(Worker::goal(i % 2 ? 1 : 5));
                if (i == 0) boss.client.cancelGoal();
                (void)boss.client.getState();
                (void)worker.server.isPreempting();
            }
        });
    for (std::thread& thread : threads) thread.join();
    ASSERT_TRUE(soon([&] { return boss.client.getState() != State::PENDING; }));
    boss.client.client().cancelAllGoals();
    EXPECT_TRUE(soon([&] { return boss.client.isDone(); }));
}

TEST_F(RosActionClient, AClientIsDestroyedWhileItsGoalIsActive) {
    addTypes();
    run(false);
    RTT::TaskContext other("other");
    auto client = std::make_unique<RTTActionClient<TestAction>>();
    ASSERT_TRUE(client->addPorts(other.provides()));
    EXPECT_FALSE(client->addPorts(other.provides()));
    ASSERT_TRUE(other.ports()->getPort("_action_goal")->connectTo(worker.ports()->getPort("_action_goal")));
    ASSERT_TRUE(worker.ports()->getPort("_action_status")->connectTo(other.ports()->getPort("_action_status")));
    ASSERT_TRUE(other.start());
    const auto handle = client->sendGoal(Worker::goal(5));
    ASSERT_TRUE(soon([&] { return handle.getCommState() == actionlib::CommState::ACTIVE; }));
    client.reset();
    EXPECT_EQ(nullptr, other.ports()->getPort("_action_goal"));
    EXPECT_TRUE(worker.server.isActive());
}

}  // namespace
