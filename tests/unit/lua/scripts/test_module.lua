-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Functions of the module `rtt`.
local check = require("check")

check.yes(require("rtt") == rtt)
local s, ns = rtt.getTime()
check.yes(s > 0 and ns >= 0 and ns < 1e9)
rtt.sleep(0, 20000000)
local s2, ns2 = rtt.getTime()
check.yes((s2 - s) + (ns2 - ns) / 1e9 >= 0.0199)
check.fails("number", rtt.sleep)
check.fails("cannot sleep", rtt.sleep, -1, 0)

check.has(" Lua ", " " .. table.concat(rtt.services(), " ") .. " ")
check.has("rtt-types", table.concat(rtt.typekits(), " "))
check.has(" int ", " " .. table.concat(rtt.types(), " ") .. " ")

check.has("ORO_SCHED_RT", table.concat(rtt.globals_getNames(), " "))
check.equal("table", type(rtt.globals_getProperties()))
check.equal("number", type(rtt.globals_get("ORO_SCHED_RT")))
check.equal(nil, rtt.globals_get("no_such_global"))
check.fails("string", rtt.globals_get)

local before = rtt.getLogLevel()
for _, level in ipairs({ "Never", "Fatal", "Critical", "Error", "Warning", "Info", "Debug", "RealTime" }) do
   rtt.setLogLevel(level)
   check.equal(level, rtt.getLogLevel())
end
check.fails("no log level 'Loud'", rtt.setLogLevel, "Loud")
rtt.setLogLevel(before)
rtt.setLogLevel("Info")
rtt.log("a line of ", 3, " parts")
rtt.logl("Warning", "a warning ", 4)
rtt.setLogLevel(before)
check.fails("no log level", rtt.logl, "Loud", "x")
check.fails("string", rtt.logl, "Error", {})
check.fails("string", rtt.log, nil)

check.equal("Deployer", rtt.getTC():getName())

-- Status names.
check.equal("NoData", (rtt.InputPort.new("int", "i"):read()))
check.equal("NewData", rtt.Variable.new("FlowStatus", rtt.globals_get("NewData")):tolua())
check.equal("SendNotReady", rtt.Variable.new("SendStatus", "SendNotReady"):tolua())
check.equal("NotConnected", rtt.Variable.new("WriteStatus", "NotConnected"):tolua())
check.fails("no value 'Stale'", rtt.Variable.new, "FlowStatus", "Stale")
check.done()
