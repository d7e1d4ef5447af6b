// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_ACTIONLIB_ACTION_NODE_HPP
#define OROFORGE_TESTS_ROS_ACTIONLIB_ACTION_NODE_HPP

#include "../ros_topic/plain_node.hpp"

#include <actionlib/TestAction.h>
#include <rtt/TaskContext.hpp>
#include <rtt_actionlib/rtt_simple_action_server.h>

namespace action_test {

using oroforge::test::RosMaster;
using ros_test::soon;

/** Registers the messages of actionlib::TestAction, with their transport. */
void addTypes();

/** A node for whose process these types are registered. */
class Node : public ros_test::PlainNode {
public:
    Node() { addTypes(); }
};

/** Accepts each goal. A goal of 1 succeeds at once, with the result 2 and the feedback 3; others wait for what the test
    does, or for their cancellation, which has the result 7. */
class Worker : public RTT::TaskContext {
public:
    explicit Worker(const std::string& name = "worker");
    ~Worker() override { stop(); }
    rtt_actionlib::RTTSimpleActionServer<actionlib::TestAction> server;

    static actionlib::TestResult result(int value) {
        actionlib::TestResult made;
        made.result = value;
        return made;
    }
    static actionlib::TestGoal goal(int value) {
        actionlib::TestGoal made;
        made.goal = value;
        return made;
    }

protected:
    bool startHook() override { return server.start(); }
    void cleanupHook() override { server.shutdown(); }

private:
    void onGoal(const actionlib::TestGoal& goal);
    void onCancel() { server.cancelActive(result(7), "as you like"); }
};

}  // namespace action_test

#endif
