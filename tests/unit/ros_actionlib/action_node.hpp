// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_ROS_ACTIONLIB_ACTION_NODE_HPP
#define OROFORGE_TESTS_ROS_ACTIONLIB_ACTION_NODE_HPP

#include <actionlib/TestAction.h>
#include <rtt/TaskContext.hpp>
#include <rtt_actionlib/rtt_simple_action_server.h>
#include <support/ros_master.hpp>

#include <chrono>
#include <functional>
#include <memory>

namespace ros {
class AsyncSpinner;
}

namespace action_test {

using oroforge::test::RosMaster;

/** Registers the messages of actionlib::TestAction, with their transport. */
void addTypes();

/** Makes this process the node /tester of a master of its own. */
class Node {
public:
    Node();
    ~Node();
    RosMaster& master() { return master_; }

private:
    RosMaster master_;
    std::unique_ptr<ros::AsyncSpinner> spinner_;
};

/** True as soon as `condition` is. */
bool soon(const std::function<bool()>& condition, std::chrono::milliseconds limit = std::chrono::seconds(10));

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
