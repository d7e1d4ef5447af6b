-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Millions of values, hundred thousands of ports and properties: the process does not grow.
local check = require("check")

local function memory()
   for line in io.lines("/proc/self/status") do
      local kilobytes = line:match("^VmRSS:%s*(%d+)")
      if kilobytes then return tonumber(kilobytes) end
   end
end

local function rounds(number, func)
   for _ = 1, number / 4 do func() end
   collectgarbage()
   collectgarbage()
   local before = memory()
   for _ = 1, number do func() end
   collectgarbage()
   collectgarbage()
   local grown = memory() - before
   -- Allocators keep some.
   local line = debug.getinfo(func).linedefined
   check.yes(grown < 4000, number .. " rounds of line " .. line .. " grow by " .. grown .. " kB")
end

rounds(1000000, function() return rtt.Variable.new("int", 3) end)
rounds(100000, function() return rtt.Variable.new("/sample/Tank") end)
rounds(100000, function() return rtt.Property.new("double", "p", "d") end)
rounds(100000, function() return rtt.Attribute.new("double", "a") end)
rounds(100000, function() return rtt.InputPort.new("double", "i") end)
rounds(100000, function() return rtt.OutputPort.new("double", "o") end)
rounds(10000, function()
   local o, i = rtt.OutputPort.new("double", "o"), rtt.InputPort.new("double", "i")
   o:connect(i)
   o:write(1)
   i:read()
end)
local add = rtt.TaskContext.getOperation(rtt.TaskContext.getPeer(rtt.getTC(), "zoo"), "add")
rounds(100000, function() return add:send(1, 2) end)
rounds(100000, function() return add(1, 2) end)
check.done()
