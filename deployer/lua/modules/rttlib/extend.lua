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
local function described(kind, func)
   return function(thing)
      local known, text = pcall(func, thing)
      return known and text or kind .. " (" .. tostring(text) .. ")"
   end
end

local function makeTexts(rttlib)
   local metatables = debug.getregistry()
   for kind, func in pairs({
      Variable = rttlib.var2str, Property = rttlib.prop2str, Attribute = rttlib.attr2str, InputPort = rttlib.port2str,
      OutputPort = rttlib.port2str, Operation = rttlib.op2str, Service = rttlib.service2str,
      ServiceRequester = rttlib.service_req2str, TaskContext = rttlib.tc2str,
   }) do
      metatables[kind].__tostring = described(kind, func)
   end
   for _, kind in ipairs({ "SendHandle", "EEHook" }) do
      metatables[kind].__tostring = function() return kind end
   end
end

return function(rttlib)
   makeGlobals()
   makeTexts(rttlib)
   rtt.operations_first()
   rtt.Variable.fromtab = rttlib.varfromtab
   rtt.Variable.totab = rttlib.var2tab
   rtt.TaskContext.show = function(tc, full) print(rttlib.tc2str(tc, full)) end
   rtt.TaskContext.stat = rttlib.tc_stat
end
