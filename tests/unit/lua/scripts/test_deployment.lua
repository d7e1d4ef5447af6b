-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Scripts as people write them: many components, a generator, an echo, mirrors.
local check = require("check")
require("rttlib")
local tc = rtt.getTC()
local of = rtt.TaskContext
local depl = tc:getName() == "lua" and tc:getPeer("Deployer") or tc

-- 100 components of Lua, each with a state and a thread of its own, in a chain.
local number = 100
local code = [[
   require("rttlib")
   tc = rtt.getTC()
   into = rtt.InputPort("int", "into")
   out = rtt.OutputPort("int", "out")
   function configureHook()
      tc:addEventPort(into)
      tc:addPort(out)
      return true
   end
   function updateHook()
      local status, value = into:read()
      if status == "NewData" then out:write(value + 1) end
   end
   function cleanupHook() rttlib.tc_cleanup() end
]]
for i = 1, number do
   local name = "c" .. i
   check.yes(depl:loadComponent(name, "OCL::LuaComponent"))
   local c = of.getPeer(depl, name)
   c:getProperty("lua_string"):set(code)
   check.yes(c:configure())
end
local cp = rtt.Variable("ConnPolicy")
cp.type, cp.size = rtt.globals.BUFFER, 10
for i = 1, number - 1 do check.yes(depl:connect("c" .. i .. ".out", "c" .. (i + 1) .. ".into", cp)) end
for i = 1, number do check.yes(of.getPeer(depl, "c" .. i):start()) end
local first = rttlib.port_clone_conn(of.getPort(of.getPeer(depl, "c1"), "into"))
local last = rttlib.port_clone_conn(of.getPort(of.getPeer(depl, "c" .. number), "out"))
first:write(1)
check.soon(function() return select(2, last:read()) == 1 + number end)
for i = 1, number do
   local c = of.getPeer(depl, "c" .. i)
   check.yes(c:stop())
   check.yes(c:cleanup())
   check.equal({}, of.getPortNames(c))
   check.yes(depl:unloadComponent("c" .. i))
end

-- A sinus generator with properties, periodic.
check.yes(depl:loadComponent("sinus", "OCL::LuaComponent"))
local sinus = of.getPeer(depl, "sinus")
check.yes(sinus:exec_str([[
   require("rttlib")
   tc = rtt.getTC()
   iface = rttlib.create_if({ ports = {{ name = "sinus", datatype = "double", type = "out", desc = "The value" }},
      properties = {{ name = "amplitude", datatype = "double" }, { name = "omega", datatype = "double" }} })
   function startHook()
      amplitude, omega, t = iface.props.amplitude:get(), iface.props.omega:get(), 0
      return amplitude > 0
   end
   function updateHook()
      t = t + tc:getPeriod()
      iface.ports.sinus:write(amplitude * math.sin(omega * t))
   end
]]))
check.yes(depl:setActivity("sinus", 0.002, 0, rtt.globals.ORO_SCHED_OTHER))
check.yes(sinus:configure())
check.no(sinus:start())
sinus:getProperty("amplitude"):set(2)
sinus:getProperty("omega"):set(100)
local value = rttlib.port_clone_conn(of.getPort(sinus, "sinus"))
check.yes(sinus:start())
local least, most, samples = 0, 0, 0
check.soon(function()
   local status, x = value:read()
   if status == "NewData" then least, most, samples = math.min(least, x), math.max(most, x), samples + 1 end
   return least < -1 and most > 1
end)
check.yes(least >= -2 and most <= 2)
check.yes(sinus:stop())

-- An echo of structs through a component of C++, and mirrors of components.
local zoo = of.getPeer(depl, "zoo")
local mirror = rttlib.mirror(zoo)
check.yes(of.start(zoo))
check.soon(function()
   mirror.tank_in:write({ id = 5, levels = { 1, 2, 3 }, mode = "Filling" })
   of.getOperation(zoo, "trigger")()
   local status, tank = mirror.tank_out:read()
   return status ~= "NoData" and tank.id == 5 and tank.levels[2] == 3 and tostring(tank.mode) == "Filling"
end)
check.yes(of.stop(zoo))

-- Errors of hooks.
check.yes(depl:loadComponent("bad", "OCL::LuaComponent"))
local bad = of.getPeer(depl, "bad")
check.no(bad:exec_str("this is no Lua"))
check.no(bad:exec_file("/no/such/file.lua"))
check.yes(bad:exec_str("function configureHook() return 1 end"))
check.no(bad:configure())
check.yes(bad:exec_str("function configureHook() error('on purpose') end"))
check.no(bad:configure())
check.yes(bad:exec_str("function configureHook() return true end function updateHook() error('again') end"))
check.yes(bad:configure())
check.yes(bad:start())
check.soon(function() return of.getState(bad) == "Exception" end)
check.done()
