// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Servers in components, with clients of ROS.
#include "action_node.hpp"

#include <actionlib/client/action_client.h>
#include <actionlib/client/simple_action_client.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <thread>

namespace {

using namespace action_test;
using actionlib::CommState;
using actionlib::TerminalState;
using actionlib::TestAction;
using testing::HasSubstr;
typedef actionlib::ActionClient<TestAction> Client;
typedef Client::GoalHandle GoalHandle;

bool isDone(const GoalHandle& goal) { return goal.getCommState() == CommState::DONE; }

class RosActionServer : public testing::Test {
protected:
    RosActionServer() {
        EXPECT_TRUE(worker.loadService("actionlib"));
        RTT::OperationCaller<bool(std::string)> connect(worker.provides("actionlib")->getOperation("connect"));
        EXPECT_TRUE(connect("/job"));
        EXPECT_TRUE(worker.server.ready());
        EXPECT_TRUE(worker.start());
    }
    Node node;
    Worker worker;
};

TEST_F(RosActionServer, APythonClientHasFeedbackResultAndCancels) {
    std::atomic<bool> isOver{false};
    std::thread reporter([&] {
        actionlib::TestFeedback feedback;
        feedback.feedback = 3;
        for (; !isOver; std::this_thread::sleep_for(std::chrono::milliseconds(5)))
            (void)worker.server.publishFeedback(feedback);
    });
    const auto outcome = RosMaster::tool({"/usr/bin/python3", ACTION_CLIENT_PY, "/job"});
    isOver = true;
    reporter.join();
    EXPECT_EQ("well done 2\nas you like 7 3\n", outcome.out) << outcome.err;
}

TEST_F(RosActionServer, TheTopicsAreThoseOfActionlib) {
    EXPECT_THAT(RosMaster::tool({"rostopic", "list"}).out,
                HasSubstr("/job/cancel\n/job/feedback\n/job/goal\n/job/result\n/job/status\n"));
}

TEST_F(RosActionServer, ANewGoalAbortsTheActiveOne) {
    Client client("/job");
    ASSERT_TRUE(client.waitForActionServerToStart(ros::Duration(10)));
    const GoalHandle first = client.sendGoal(Worker::goal(5));
    ASSERT_TRUE(soon([&] { return first.getCommState() == CommState::ACTIVE; }));
    EXPECT_EQ(5, worker.server.getActiveGoal()->goal);
    EXPECT_FALSE(worker.server.isPending());
    const GoalHandle second = client.sendGoal(Worker::goal(6));
    ASSERT_TRUE(soon([&] { return isDone(first); }));
    EXPECT_EQ(TerminalState::ABORTED, first.getTerminalState().state_);
    EXPECT_EQ("a newer goal", first.getTerminalState().getText());
    EXPECT_EQ(8, first.getResult()->result);
    ASSERT_TRUE(soon([&] { return second.getCommState() == CommState::ACTIVE; }));
    EXPECT_TRUE(worker.server.abortActive(Worker::result(9), "broken"));
    EXPECT_FALSE(worker.server.abortActive(Worker::result(9)));
    ASSERT_TRUE(soon([&] { return isDone(second); }));
    EXPECT_EQ(TerminalState::ABORTED, second.getTerminalState().state_);
    EXPECT_FALSE(worker.server.isActive());
}

TEST_F(RosActionServer, APendingGoalGivesWayAndIsCancelled) {
    worker.server.setGoalHook(nullptr);
    Client client("/job");
    ASSERT_TRUE(client.waitForActionServerToStart(ros::Duration(10)));
    const GoalHandle first = client.sendGoal(Worker::goal(5));
    ASSERT_TRUE(soon([&] { return worker.server.isPending(); }));
    EXPECT_EQ(5, worker.server.getPendingGoal()->goal);
    EXPECT_EQ(nullptr, worker.server.getActiveGoal());
    GoalHandle second = client.sendGoal(Worker::goal(6));
    ASSERT_TRUE(soon([&] { return isDone(first); }));
    EXPECT_EQ(TerminalState::REJECTED, first.getTerminalState().state_);
    second.cancel();
    ASSERT_TRUE(soon([&] { return isDone(second); }));
    EXPECT_EQ(TerminalState::RECALLED, second.getTerminalState().state_);
    const GoalHandle third = client.sendGoal(Worker::goal(7));
    ASSERT_TRUE(soon([&] { return worker.server.isPending(); }));
    EXPECT_TRUE(worker.server.rejectPending(Worker::result(4), "not today"));
    ASSERT_TRUE(soon([&] { return isDone(third); }));
    EXPECT_EQ("not today", third.getTerminalState().getText());
    EXPECT_FALSE(worker.server.acceptPending(Worker::result(0)));
}

TEST_F(RosActionServer, TwoClientsGetTheirOwnResults) {
    actionlib::SimpleActionClient<TestAction> one("/job"), other("/job");
    ASSERT_TRUE(one.waitForServer(ros::Duration(10)));
    ASSERT_TRUE(other.waitForServer(ros::Duration(10)));
    one.sendGoal(Worker::goal(5));
    ASSERT_TRUE(soon([&] { return worker.server.isActive(); }));
    other.sendGoal(Worker::goal(1));
    ASSERT_TRUE(one.waitForResult(ros::Duration(10)));
    ASSERT_TRUE(other.waitForResult(ros::Duration(10)));
    EXPECT_EQ(8, one.getResult()->result);
    EXPECT_EQ(2, other.getResult()->result);
    EXPECT_EQ(actionlib::SimpleClientGoalState::SUCCEEDED, other.getState().state_);
}

TEST_F(RosActionServer, NoMessageOfABurstIsLost) {
    Client client("/job");
    ASSERT_TRUE(client.waitForActionServerToStart(ros::Duration(10)));
    std::vector<GoalHandle> goals;
    std::atomic<int> feedbacks{0};
    for (int i = 0; i != 10; ++i)
        goals.push_back(client.sendGoal(Worker::goal(1), boost::function<void(GoalHandle)>(),
                                        [&](GoalHandle, const actionlib::TestFeedbackConstPtr&) { ++feedbacks; }));
    for (const GoalHandle& goal : goals) {
        ASSERT_TRUE(soon([&] { return isDone(goal); }));
        EXPECT_EQ(TerminalState::SUCCEEDED, goal.getTerminalState().state_);
    }
    EXPECT_TRUE(soon([&] { return feedbacks == 10; }));
}

TEST_F(RosActionServer, ShutdownEndsTheGoalsAndAStartTakesNewOnes) {
    Client client("/job");
    ASSERT_TRUE(client.waitForActionServerToStart(ros::Duration(10)));
    const GoalHandle goal = client.sendGoal(Worker::goal(5));
    ASSERT_TRUE(soon([&] { return worker.server.isActive(); }));
    ASSERT_TRUE(worker.stop());
    ASSERT_TRUE(worker.cleanup());
    ASSERT_TRUE(soon([&] { return isDone(goal); }));
    EXPECT_EQ(TerminalState::ABORTED, goal.getTerminalState().state_);
    EXPECT_THAT(goal.getTerminalState().getText(), HasSubstr("shut down"));
    EXPECT_FALSE(worker.server.isActive());
    ASSERT_TRUE(worker.configure());
    ASSERT_TRUE(worker.start());
    const GoalHandle next = client.sendGoal(Worker::goal(1));
    EXPECT_TRUE(soon([&] { return isDone(next); }));
}

TEST_F(RosActionServer, AGoalThatCameWhileTheComponentWasStoppedIsTaken) {
    Client client("/job");
    ASSERT_TRUE(client.waitForActionServerToStart(ros::Duration(10)));
    ASSERT_TRUE(worker.stop());
    const GoalHandle goal = client.sendGoal(Worker::goal(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(CommState::WAITING_FOR_GOAL_ACK, goal.getCommState().state_);
    ASSERT_TRUE(worker.start());
    EXPECT_TRUE(soon([&] { return isDone(goal); }));
}

TEST_F(RosActionServer, AServerIsDestroyedWhileGoalsAreActive) {
    Client client("/other");
    auto other = std::make_unique<Worker>("other");
    ASSERT_TRUE(other->server.server().bridge().createStream("/other"));
    ASSERT_TRUE(other->start());
    ASSERT_TRUE(client.waitForActionServerToStart(ros::Duration(10)));
    std::atomic<bool> isOver{false};
    std::thread sender([&] {
        while (!isOver) {
            (void)client.sendGoal(Worker::goal(5));
            client.cancelAllGoals();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    ASSERT_TRUE(soon([&] { return other->server.isActive(); }));
    other.reset();
    isOver = true;
    sender.join();
}

}  // namespace
