-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- rttlib: texts of ports, operations, services, components; what prints them.
local check = require("check")
require("rttlib")
local tc = rtt.getTC()
local zoo = rtt.TaskContext.getPeer(tc, "zoo")

local port = zoo:getPort("numbers_in")
check.equal("numbers_in [in, double, unconn, local] // Numbers", rttlib.port2str(port))
check.equal("numbers_in [in, double, unconn, local]", rttlib.port2str(port, true))
check.equal(rttlib.port2str(port), tostring(port))
check.equal("numbers_out [out, double, unconn, local] // The numbers again", tostring(zoo:getPort("numbers_out")))
check.equal("double add(double a, double b) // Adds", rttlib.op2str(zoo:getOperation("add")))
check.equal("double add(double a, double b) // Adds", tostring(zoo:getOperation("add")))
check.equal("double add(double a, double b) // Adds", rttlib.tc_op2str(zoo, "add"))
check.equal("double twice(double x) // Doubles", rttlib.tc_op2str(zoo:provides("inner"), "twice"))
check.fails("subtract", rttlib.tc_op2str, zoo, "subtract")

local service = rttlib.service2str(zoo:provides("inner"))
for _, part in ipairs({ "Service inner // An inner service", "depth (double) = 2.5", "mark (int) = 3",
   "inner_out [out, double", "double twice(double x) // Doubles", "Service most", "void deep()" }) do
   check.has(part, service)
end
check.equal(service, tostring(zoo:provides("inner")))
local requester = rttlib.service_req2str(zoo:requires("helper"))
check.has("Requester helper [not ready]", requester)
check.has("twice", requester)
check.has("Requester", tostring(zoo:requires()))

local text = rttlib.tc2str(zoo)
for _, part in ipairs({ "TaskContext zoo [Stopped]", "gain (double) = 1 // A factor", "limit (int) = 9",
   "numbers_in [in", "int divide(int a, int b, int & rest)" }) do
   check.has(part, text)
end
check.no(text:find("Service inner"), "a service")
check.has("Service inner", rttlib.tc2str(zoo, true))
check.has("Requester helper", rttlib.tc2str(zoo, true))
-- Its thread may be counting.
local function still(counted) return (counted:gsub("Counter %(uint%) = %d+", "Counter")) end
check.equal(still(text), still(tostring(zoo)))
check.equal(still(text), still(check.printed(rttlib.pptc, zoo)))
check.equal(still(text), still(check.printed(function() zoo:show() end)))
check.has("Peers: ", rttlib.tc2str(tc))

-- Values of ports.
local out = rtt.OutputPort("double", "numbers")
out:connect(port)
check.equal("NoData", rttlib.portval2str(port, zoo))
out:write(2.5)
check.equal("2.5", rttlib.portval2str(port, zoo))
local mine = rtt.OutputPort("/sample/Point", "mine")
rtt.TaskContext.addPort(tc, mine)
mine:connect(rtt.InputPort("/sample/Point", "into"))
mine:write({ x = 1, y = 2 })
check.equal("{x=1,y=2}", rttlib.portval2str(mine, tc))
check.equal("{x=1,y=2}", rttlib.portval2str(mine))
check.equal("mine [out, /sample/Point, conn, local] = {x=1,y=2}", check.printed(rttlib.portstats, tc))
check.has("numbers_in [in, double, conn, local]", check.printed(rttlib.portstats, zoo))

-- Operations hide methods; the table has them.
check.equal("the operation", zoo:getName())
check.equal("zoo", rtt.TaskContext.getName(zoo))
check.equal(5, zoo:add(2, 3))
check.equal(6, zoo:provides("inner"):twice(3))

-- A deleted thing has a text.
tc:loadComponent("gone", "OCL::LuaComponent")
local gone = rtt.TaskContext.getPeer(tc, "gone")
tc:unloadComponent("gone")
check.has("TaskContext", tostring(gone))
mine:delete()
check.has("deleted", tostring(mine))

local help = {}
local stdout = io.stdout
io.stdout = { write = function(_, one) help[#help + 1] = one end }
rttlib.help()
io.stdout = stdout
for name, func in pairs(rttlib) do
   if type(func) == "function" and name ~= "help" and name ~= "tc_stat" then check.has(name, help[1]) end
end
check.done()
