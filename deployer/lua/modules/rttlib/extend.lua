-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- What rttlib adds to the types of the module `rtt`.

-- rtt.globals.X is the global attribute or property X, nil if there is none.
local function makeGlobals()
   rtt.globals = setmetatable({}, {
      __index = function(_, name) return rtt.globals_get(name) end,
      __newindex = function(_, name) error("rtt.globals." .. tostring(name) .. " cannot be assigned", 2) end,
   })
end

-- A thing whose component is gone has a text, too.
local function described(rttlib, kind, name)
   return function(thing)
      local known, text = pcall(rttlib[name], thing)
      return known and text or kind .. " (" .. tostring(text) .. ")"
   end
end

local function makeTexts(rttlib)
   local metatables = debug.getregistry()
   for kind, name in pairs({
      Variable = "var2str", Property = "prop2str", Attribute = "attr2str", InputPort = "port2str",
      OutputPort = "port2str", Operation = "op2str", Service = "service2str", ServiceRequester = "service_req2str",
      TaskContext = "tc2str",
   }) do
      metatables[kind].__tostring = described(rttlib, kind, name)
   end
   for _, kind in ipairs({ "SendHandle", "EEHook" }) do
      metatables[kind].__tostring = function() return kind end
   end
end

return function(rttlib)
   makeGlobals()
   makeTexts(rttlib)
   rtt.operations_first()
   rtt.Variable.fromtab = function(...) return rttlib.varfromtab(...) end
   rtt.Variable.totab = function(...) return rttlib.var2tab(...) end
   rtt.TaskContext.show = function(tc, full) print(rttlib.tc2str(tc, full)) end
   rtt.TaskContext.stat = function(...) return rttlib.tc_stat(...) end
end
