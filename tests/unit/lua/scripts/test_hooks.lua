-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- EEHook: a Lua function in the engine of the component.
local check = require("check")
local tc = rtt.getTC()
local of = rtt.TaskContext

check.yes(tc:loadComponent("hooked", "OCL::LuaComponent"))
local c = of.getPeer(tc, "hooked")
check.yes(tc:setActivity("hooked", 0.001, 0, rtt.globals_get("ORO_SCHED_OTHER")))
check.yes(c:exec_str([[
   calls, limit = 0, 1e9
   out = rtt.OutputPort.new("int", "calls")
   rtt.TaskContext.addPort(rtt.getTC(), out)
   function step()
      calls = calls + 1
      out:write(calls)
      return calls < limit
   end
   function failing() error("on purpose") end
   function numeric() return 1 end
   hook = rtt.EEHook.new("step")
   assert(hook:enable() == true)
]]))
local calls = rtt.InputPort.new("int", "calls")
check.yes(calls:connect(of.getPort(c, "calls")))
check.yes(of.configure(c) and of.start(c))
local function number() return select(2, calls:read()) or 0 end
check.soon(function() return number() > 5 end)
check.yes(c:exec_str("assert(hook:disable() == true)"))
local at = number()
rtt.sleep(0, 30000000)
check.equal(at, number())
-- It ends when it returns false, and can be enabled again.
check.yes(c:exec_str("limit = calls + 3 hook:enable()"))
check.soon(function() return number() == at + 3 end)
rtt.sleep(0, 30000000)
check.equal(at + 3, number())
check.yes(c:exec_str("limit = calls + 2 hook:enable()"))
check.soon(function() return number() == at + 5 end)
-- Functions that fail, or are none, are removed and the component goes on.
for _, name in ipairs({ "failing", "numeric", "missing" }) do
   check.yes(c:exec_str("rtt.EEHook.new('" .. name .. "'):enable()"))
end
rtt.sleep(0, 30000000)
check.equal("Running", of.getState(c))
check.fails("string", rtt.EEHook.new)
check.done()
