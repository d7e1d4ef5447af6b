-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- State machines of rFSM in components. rFSM itself is not part of this; require("rfsm") has to find it.
require("rttlib")

local rfsm_rtt = {}

local function portsOf(...)
   local ports = { ... }
   if #ports == 0 then error("this takes the input ports to read events from", 3) end
   for i, port in ipairs(ports) do
      if rttlib.rtt_type(port) ~= "InputPort" then
         error("argument " .. i .. " is a " .. rttlib.rtt_type(port) .. ", not an InputPort", 3)
      end
   end
   return ports
end

local function reader(ports)
   return function()
      local events = {}
      for _, port in ipairs(ports) do
         local status, event = port:read()
         while status == "NewData" do
            events[#events + 1] = rttlib.var2tab(event)
            status, event = port:read()
         end
      end
      return events
   end
end

--- A function for fsm.getevents: it gives all samples that came to the ports, in a list. Enumerations are their names.
function rfsm_rtt.gen_read_events(...) return reader(portsOf(...)) end

--- The same for ports of type string only.
function rfsm_rtt.gen_read_str_events(...)
   local ports = portsOf(...)
   for _, port in ipairs(ports) do
      local info = port:info()
      if info.type ~= "string" then
         error("port '" .. info.name .. "' has type " .. info.type .. ", not string", 2)
      end
   end
   return reader(ports)
end

--- A function that writes the events that it is given to an output port, and also sends them to `fsm` if there is one.
function rfsm_rtt.gen_raise_event(port, fsm)
   if rttlib.rtt_type(port) ~= "OutputPort" then
      error("gen_raise_event: this takes an OutputPort, not a " .. rttlib.rtt_type(port), 2)
   end
   return function(...)
      for i = 1, select("#", ...) do port:write((select(i, ...))) end
      if fsm then require("rfsm").send_events(fsm, ...) end
   end
end

--- A function for rfsm.post_step_hook_add(): when another state is active, it writes that state's full name to a port
-- of type string. With `filter`, a pattern or a function, only names that it matches or gives something for; the text
-- that a function gives is written in place of the name.
function rfsm_rtt.gen_write_fqn(port, filter)
   if rttlib.rtt_type(port) ~= "OutputPort" or port:info().type ~= "string" then
      error("gen_write_fqn: this takes an OutputPort of type string", 2)
   end
   local last
   port:write("<none>")
   return function(fsm)
      local leaf = fsm._act_leaf
      local name = leaf and leaf._fqn or "<none>"
      if name == last then return end
      last = name
      local wanted = name
      if type(filter) == "function" then
         wanted = filter(name)
         if wanted == true then wanted = name end
      elseif filter then
         wanted = name:match(filter) and name
      end
      if wanted then port:write(wanted) end
   end
end

-- The code that the interpreter of the component executes.
local launch = [[
require("rttlib")
local rfsm = require("rfsm")
fsm = rfsm.init(rfsm.load(%q))
if not fsm then error("the state machine cannot be used") end
]]
local inEngine = [[
function rfsm_in_engine()
   rfsm.run(fsm)
   return true
end
rfsm_hook = rtt.EEHook("rfsm_in_engine")
if not rfsm_hook:enable() then error("the engine takes no function") end
]]

--- Has a component execute the state machine in a file by its service Lua, which is loaded if it has none; the machine
-- is the global `fsm` there. With `ee` each step of the component's engine runs it; otherwise it runs once, until it is
-- idle. An error if that fails.
function rfsm_rtt.service_launch_rfsm(file, tc, ee)
   local of = rtt.TaskContext
   local known = false
   for _, name in ipairs(of.getProviderNames(tc)) do known = known or name == "Lua" end
   if not known and not of.loadService(tc, "Lua") then
      error("component '" .. of.getName(tc) .. "' cannot load the service Lua", 2)
   end
   local code = launch:format(file) .. (ee and inEngine or "rfsm.run(fsm)\n")
   local execute = rtt.Service.getOperation(of.provides(tc, "Lua"), "exec_str")
   if not execute(code) then
      error("component '" .. of.getName(tc) .. "' cannot launch " .. file .. "; see the log", 2)
   end
   return true
end

return rfsm_rtt
