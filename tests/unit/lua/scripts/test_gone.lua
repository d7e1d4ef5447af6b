-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- What belongs to a component that was destroyed answers with errors.
local check = require("check")
local tc = rtt.getTC()
local of = rtt.TaskContext

check.yes(tc:loadComponent("short", "OCL::LuaComponent"))
local short = of.getPeer(tc, "short")
check.yes(short:exec_str([[
   local tc = rtt.getTC()
   tank = rtt.Property.new("/sample/Tank", "tank")
   out = rtt.OutputPort.new("int", "out")
   into = rtt.InputPort.new("int", "into")
   number = rtt.Attribute.new("int", "number")
   rtt.TaskContext.addProperty(tc, tank)
   rtt.TaskContext.addPort(tc, out)
   rtt.TaskContext.addPort(tc, into)
   rtt.TaskContext.addAttribute(tc, number)
   rtt.TaskContext.addOperation(tc, "answer", "int()", function() return 42 end)
   rtt.TaskContext.addOperation(tc, "own", "int()", function() return 42 end, { thread = "OwnThread" })
]]))
local property, attribute = of.getProperty(short, "tank"), of.getAttribute(short, "number")
local value, member = property:get(), property:get().position
local out, into = of.getPort(short, "out"), of.getPort(short, "into")
local mine = rtt.InputPort.new("int", "mine")
check.yes(out:connect(mine))
local service, requester = of.provides(short), of.requires(short)
local operation, handle = of.getOperation(short, "answer"), of.getOperation(short, "own"):send()
local method = short.answer
check.equal(42, operation())
check.equal("SendSuccess", (handle:collect()))
check.yes(tc:unloadComponent("short"))

for _, use in ipairs({
   function() short:start() end, function() return short.answer end, function() return short:getPorts() end,
   function() return property:get() end, function() property:set({}) end, function() return property.id end,
   function() return attribute:get() end, function() attribute:set(1) end, function() attribute:delete() end,
   function() return value.id end, function() value.id = 3 end, function() return value:tolua().id end,
   function() return member.x end, function() member:assign({ x = 1 }) end, function() return member == value end,
   function() out:write(1) end, function() return into:read() end, function() return into:info() end,
   function() into:connect(rtt.OutputPort.new("int", "o")) end, function() out:disconnect() end,
   function() out:delete() end, function() return mine:connect(out) end, function() return service:getName() end,
   function() return service:getOperationNames() end, function() return service.answer end,
   function() return requester:ready() end, function() return operation() end, function() return operation:send() end,
   function() return method(short) end, function() of.addPeer(tc, short) end, function() of.connectPorts(tc, short) end,
   function() of.delete(short) end,
}) do
   local done, why = pcall(use)
   local line = debug.getinfo(use).linedefined
   check.no(done, "the use in line " .. line)
   check.yes(done or type(why) == "string", "the error of line " .. line)
end
-- The rest goes on.
check.yes(pcall(handle.collect, handle) ~= nil)
check.no(mine:info().connected)
check.equal("NoData", (mine:read()))

-- A component of that name again is another one.
check.yes(tc:loadComponent("short", "OCL::LuaComponent"))
check.no(pcall(operation))
check.no(pcall(property.get, property))
check.equal("short", of.getName(of.getPeer(tc, "short")))
short, property, attribute, value, member, out, into, service, requester, operation, handle, method = nil
collectgarbage()
collectgarbage()
check.done()
