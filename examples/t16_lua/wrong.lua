-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- An error: text where the operation takes a number.
require("rttlib")
local depl = rtt.getTC():getPeer("Deployer")
depl:setActivity("Deployer", "10 ms", 0, rtt.globals.ORO_SCHED_OTHER)
