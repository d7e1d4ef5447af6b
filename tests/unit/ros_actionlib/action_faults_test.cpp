// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports that do not fit, no master, operations as callbacks, and messages that nobody expects.
#include "action_node.hpp"

#include "../flow/log_capture.hpp"

#include <rtt_actionlib/rtt_action_client.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

namespace {

using namespace action_test;
using actionlib::TestAction;
using flow_test::LogCapture;
using rtt_actionlib::ActionBridge;
using rtt_actionlib::RTTActionServer;
using testing::AllOf;
using testing::HasSubstr;
typedef RTTActionServer<TestAction>::GoalHandle ServerGoal;

struct Server : RTTActionServer<TestAction> {
    Server() : RTTActionServer("status", 0.02) {}
    void forgetGoalsAfter(double seconds) {
        const boost::recursive_mutex::scoped_lock lock(lock_);
        status_list_timeout_ = ros::Duration(seconds);
    }
};

/** A server, with the other ends of its ports. */
struct Bench {
    explicit Bench(RTT::TaskContext& component) {
        addTypes();
        EXPECT_TRUE(server.addPorts(component.provides()));
        EXPECT_TRUE(goals.connectTo(component.ports()->getPort("_action_goal")));
        EXPECT_TRUE(cancels.connectTo(component.ports()->getPort("_action_cancel")));
        const RTT::ConnPolicy many = RTT::ConnPolicy::buffer(1000);
        EXPECT_TRUE(component.ports()->getPort("_action_status")->connectTo(&statuses, many));
        EXPECT_TRUE(component.ports()->getPort("_action_result")->connectTo(&results, many));
        EXPECT_TRUE(component.ports()->getPort("_action_feedback")->connectTo(&feedbacks, many));
    }
    void send(const std::string& id, ros::Time stamp = ros::Time()) {
        actionlib::TestActionGoal goal;
        goal.goal_id.id = id;
        goal.goal_id.stamp = stamp;
        goals.write(goal);
    }
    void cancel(const std::string& id, ros::Time stamp = ros::Time()) {
        actionlib_msgs::GoalID message;
        message.id = id;
        message.stamp = stamp;
        cancels.write(message);
    }
    /** The status of a goal with the next result. */
    int nextResult() {
        actionlib::TestActionResult result;
        return soon([&] { return results.read(result) == RTT::NewData; }) ? result.status.status : -1;
    }
    RTT::OutputPort<actionlib::TestActionGoal> goals{"goals"};
    RTT::OutputPort<actionlib_msgs::GoalID> cancels{"cancels"};
    RTT::InputPort<actionlib_msgs::GoalStatusArray> statuses{"statuses"};
    RTT::InputPort<actionlib::TestActionResult> results{"results"};
    RTT::InputPort<actionlib::TestActionFeedback> feedbacks{"feedbacks"};
    Server server;
};

typedef actionlib_msgs::GoalStatus Status;

TEST(RosActionFaults, OperationsTakeGoalsAndCancelRequests) {
    struct Doer : RTT::TaskContext {
        Doer() : TaskContext("doer") {
            addOperation("goal", &Doer::goal, this, RTT::OwnThread);
            addOperation("cancel", &Doer::cancel, this, RTT::OwnThread);
            addOperation("odd", &Doer::odd, this);
        }
        void goal(ServerGoal handle) {
            isOwn = engine()->isSelf();
            handle.setAccepted();
        }
        void cancel(ServerGoal handle) { handle.setCanceled(); }
        void odd(int) {}
        std::atomic<bool> isOwn{false};
    } doer;
    Bench bench(doer);
    LogCapture log;
    EXPECT_FALSE(bench.server.registerGoalOperation(doer.getOperation("odd")));
    EXPECT_FALSE(bench.server.registerCancelOperation(nullptr));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("'odd'"), HasSubstr("void(GoalHandle)")));
    ASSERT_TRUE(bench.server.registerGoalOperation(doer.getOperation("goal")));
    ASSERT_TRUE(bench.server.registerCancelOperation(doer.getOperation("cancel")));
    ASSERT_TRUE(doer.start());
    bench.server.start();
    bench.send("a");
    ASSERT_TRUE(soon([&] { return doer.isOwn.load(); }));
    bench.cancel("a");
    EXPECT_EQ(Status::PREEMPTED, bench.nextResult());
    doer.stop();
}

TEST(RosActionFaults, AServerWithoutACallbackRejectsGoals) {
    RTT::TaskContext component("c");
    Bench bench(component);
    ASSERT_TRUE(component.start());
    bench.server.start();
    LogCapture log;
    bench.send("a");
    EXPECT_EQ(Status::REJECTED, bench.nextResult());
    EXPECT_THAT(log.finish(), HasSubstr("registerGoalCallback"));
    component.stop();
}

TEST(RosActionFaults, OddMessagesOfClientsAreHarmless) {
    RTT::TaskContext component("c");
    Bench bench(component);
    std::atomic<int> goals{0};
    bench.server.registerGoalCallback([&](ServerGoal handle) {
        ++goals;
        handle.setAccepted();
        handle.setSucceeded();
    });
    ASSERT_TRUE(component.start());
    bench.server.start();
    const ros::Time latest(0xffffffffu, 999999999u);
    const auto known = [&](std::size_t count) {
        actionlib_msgs::GoalStatusArray array;
        while (bench.statuses.read(array) == RTT::NewData) continue;
        return array.status_list.size() == count;
    };
    bench.cancel("never came");
    bench.cancel("neither", latest);
    ASSERT_TRUE(soon([&] { return known(2); }));
    for (const char* id : {"early", "never came", "", "again", "again"}) bench.send(id);
    bench.send("late", latest);
    EXPECT_TRUE(soon([&] { return known(6); }));
    EXPECT_EQ(3, goals);
    bench.server.forgetGoalsAfter(0.01);
    EXPECT_TRUE(soon([&] { return known(0); }));
    component.stop();
}

TEST(RosActionFaults, WithoutAMasterTheActionIsNotConnected) {
    addTypes();
    RTT::TaskContext component("c");
    RTTActionServer<TestAction> server;
    LogCapture log;
    EXPECT_FALSE(server.addPorts(component.provides(), true, "/job"));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("'/job'"), HasSubstr("rtt_rosnode")));
    EXPECT_FALSE(server.ready());
    EXPECT_FALSE(server.bridge().anyConnected());
    server.start();
    server.shutdown();
}

TEST(RosActionFaults, AServerWithoutPortsSaysSo) {
    RTTActionServer<TestAction> server("status");
    LogCapture log;
    server.start();
    server.publishStatus();
    EXPECT_FALSE(server.addPorts(nullptr));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("addPorts()"), HasSubstr("service")));
}

TEST(RosActionFaults, OneServiceHasOneAction) {
    addTypes();
    RTT::TaskContext component("c");
    RTTActionServer<TestAction> one, other;
    ASSERT_TRUE(one.addPorts(component.provides()));
    LogCapture log;
    EXPECT_FALSE(other.addPorts(component.provides()));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("_action_goal"), HasSubstr("service of its own")));
    EXPECT_TRUE(other.addPorts(component.provides("second")));
}

TEST(RosActionFaults, PortsOfOtherDirectionsAreRefused) {
    addTypes();
    RTT::InputPort<actionlib::TestActionGoal> goal("_action_goal");
    RTT::InputPort<actionlib_msgs::GoalID> cancel("_action_cancel");
    RTT::InputPort<actionlib_msgs::GoalStatusArray> status("_action_status");
    RTT::OutputPort<actionlib::TestActionResult> result("_action_result");
    RTT::OutputPort<actionlib::TestActionFeedback> feedback("_action_feedback");
    ActionBridge bridge;
    LogCapture log;
    EXPECT_FALSE(bridge.setPorts(&goal, &cancel, &status, &result, &feedback));
    EXPECT_FALSE(bridge.isValid());
    EXPECT_THROW((void)bridge.cancelInput(), std::bad_cast);
    RTT::TaskContext component("c");
    EXPECT_FALSE(bridge.setPortsFromService(component.provides()));
    EXPECT_FALSE(bridge.setPortsFromService(nullptr));
    EXPECT_FALSE(bridge.createStream("/x"));
    EXPECT_THAT(log.finish(), AllOf(HasSubstr("_action_status should be an output"), HasSubstr("'_action_feedback'"),
                                    HasSubstr("'/x'")));
    RTT::OutputPort<actionlib_msgs::GoalStatusArray> right("_action_status");
    ASSERT_TRUE(bridge.setPorts(&goal, &cancel, &right, &result, &feedback));
    EXPECT_TRUE(bridge.isServer());
    EXPECT_FALSE(bridge.isClient());
    EXPECT_EQ(&goal, &bridge.goalInput<TestAction>());
    EXPECT_THROW((void)bridge.resultInput<TestAction>(), std::bad_cast);
}

TEST(RosActionFaults, StreamsAreMadeAllOrNoneAndOnce) {
    const Node node;
    RTT::TaskContext component("c");
    RTTActionServer<TestAction> server;
    ASSERT_TRUE(server.addPorts(component.provides(), true, "~work/"));
    EXPECT_TRUE(server.ready());
    EXPECT_TRUE(server.bridge().createStream("~work/"));
    for (const RTT::base::PortInterface* port : component.ports()->getPorts())
        EXPECT_EQ(1u, port->getManager()->getConnections().size()) << port->getName();
    LogCapture log;
    EXPECT_FALSE(server.bridge().createStream("not a name"));
    EXPECT_THAT(log.finish(), HasSubstr("'not a name'"));
    component.loadService("actionlib");
    RTT::OperationCaller<bool(std::string, std::string)> connect(
        component.provides("actionlib")->getOperation("connectSub"));
    EXPECT_FALSE(connect("none", "/x"));
    EXPECT_FALSE(connect("", "/x"));
    server.bridge().clear();
    EXPECT_FALSE(server.ready());
    EXPECT_EQ("goal", rtt_actionlib::actionTopic("", "goal"));
    EXPECT_EQ("~goal", rtt_actionlib::actionTopic("~", "goal"));
    EXPECT_EQ("/a/goal", rtt_actionlib::actionTopic("/a", "goal"));
}

}  // namespace
