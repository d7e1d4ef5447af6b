-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Components with threads of their own that call each other, while one makes and forgets ports and properties.
local check = require("check")
require("rttlib")
local tc = rtt.getTC()
local of = rtt.TaskContext

local function component(name, code)
   check.yes(tc:loadComponent(name, "OCL::LuaComponent"))
   check.yes(tc:setActivity(name, 0.001, 0, rtt.globals.ORO_SCHED_OTHER))
   local made = of.getPeer(tc, name)
   check.yes(made:exec_str("require('rttlib') tc = rtt.getTC() " .. code))
   return made
end

local server = component("server", [[
   own, client, steps = 0, 0, 0
   tc:addOperation("in_own", "int(int n)", function(n) own = own + 1 return n + 1 end, { thread = "OwnThread" })
   tc:addOperation("in_client", "int(int n)", function(n) client = client + 1 return n + 1 end)
   tc:addOperation("calls", "int()", function() return own + client end)
   function updateHook()
      steps = steps + 1
      for i = 1, 60 do
         local o, n = rtt.OutputPort("int", "o"), rtt.InputPort("int", "n")
         assert(o:connect(n))
         o:write(i)
         local status, value = n:read()
         assert(status == "NewData" and value == i)
         rtt.Property("/sample/Tank", "t"):set({ id = i })
      end
   end
]])
local clients = {}
for i = 1, 3 do
   clients[i] = component("client" .. i, [[
      calls = 0
      tc:addOperation("calls", "int()", function() return calls end)
      function updateHook()
         local server = tc:getPeer("server")
         assert(server:in_own(calls) == calls + 1)
         assert(server:in_client(calls) == calls + 1)
         assert(select(2, server:getOperation("in_own"):send(7):collect()) == 8)
         calls = calls + 3
      end
   ]])
   of.addPeer(clients[i], server)
end
for _, one in ipairs({ server, unpack(clients) }) do check.yes(one:configure() and one:start()) end
rtt.sleep(1, 0)
for i = 1, 3 do
   check.equal("Running", of.getState(clients[i]))
   check.yes(clients[i]:stop())
   check.yes(clients[i]:calls() > 0, "calls of client " .. i .. " > 0")
end
check.equal("Running", of.getState(server))
local sum = clients[1]:calls() + clients[2]:calls() + clients[3]:calls()
check.equal(sum, server:calls())
check.yes(server:stop())
check.done()
