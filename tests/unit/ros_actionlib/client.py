#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Sends a goal that succeeds and one that it cancels, and prints what comes back."""
import sys

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from actionlib.msg import TestAction, TestGoal

rospy.init_node("python_client")
client = actionlib.SimpleActionClient(sys.argv[1], TestAction)
if not client.wait_for_server(rospy.Duration(10)):
    sys.exit("no server")


def until(state):
    """Does not rely on callbacks: those that come before send_goal() has returned are lost."""
    while client.get_state() != state and not rospy.is_shutdown():
        rospy.sleep(0.005)


seen = []
client.send_goal(TestGoal(goal=1))
until(GoalStatus.SUCCEEDED)
print(client.get_goal_status_text(), client.get_result().result, flush=True)
client.send_goal(TestGoal(goal=5), feedback_cb=lambda feedback: seen.append(feedback.feedback))
until(GoalStatus.ACTIVE)
while not seen and not rospy.is_shutdown():
    rospy.sleep(0.005)
client.cancel_goal()
until(GoalStatus.PREEMPTED)
print(client.get_goal_status_text(), client.get_result().result, seen[0], flush=True)
