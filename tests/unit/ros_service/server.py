# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Services that clients of the tests call."""
import sys

import rospy
from std_srvs.srv import SetBool, SetBoolResponse, Trigger, TriggerResponse


def switch(request):
    return SetBoolResponse(success=request.data, message="on" if request.data else "off")


def slow(_):
    rospy.sleep(float(sys.argv[1]) if len(sys.argv) > 1 else 30.0)
    return TriggerResponse(success=True, message="late")


def broken(_):
    raise RuntimeError("the pump is broken")


rospy.init_node("server", disable_signals=False)
services = [rospy.Service("/switch", SetBool, switch), rospy.Service("/slow", Trigger, slow), rospy.Service("/broken", Trigger, broken)]
print("ready", flush=True)
rospy.spin()
