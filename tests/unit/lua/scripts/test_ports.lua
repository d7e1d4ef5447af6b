-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Ports.
local check = require("check")
local tc = rtt.getTC()
local of = rtt.TaskContext
local In, Out = rtt.InputPort.new, rtt.OutputPort.new

local o, i = Out("int", "o", "Out it goes"), In("int", "i", "In it comes")
check.equal({ name = "o", desc = "Out it goes", type = "int", porttype = "out", connected = false, isLocal = true },
   o:info())
check.equal("in", i:info().porttype)
check.equal("i [in, int, unconn, local] // In it comes", tostring(i))
check.yes(o:connect(i))
check.equal("i [in, int, conn, local] // In it comes", tostring(i))
check.yes(o:info().connected)
local status, value = i:read()
-- As in the original: scripts use the value without looking at the status.
check.equal("NoData", status)
check.equal(0, value)
o:write(3)
status, value = i:read()
check.equal("NewData", status)
check.equal(3, value)
status, value = i:read()
check.equal("OldData", status)
check.equal(3, value)
local v = rtt.Variable.new("int", 8)
o:write(v)
v:assign(0)
check.equal("NewData", i:read(v))
check.equal(8, v:tolua())
check.equal("OldData", i:read(v))
check.fails("samples of type int", i.read, i, rtt.Variable.new("double"))
check.fails("Variable", i.read, i, 3)
check.fails("cannot make a int", o.write, o, "text")
check.fails("", o.write, o)
check.fails("cannot be assigned", o.write, o, rtt.Variable.new("strings"))
check.yes(o:disconnect(i))
check.no(o:info().connected)
status, value = i:read()
check.equal({ "NoData", 0 }, { status, value })

-- Policies: a Variable, and a table of its members.
local policy = rtt.Variable.new("ConnPolicy")
policy.type = rtt.globals_get("BUFFER")
policy.size = 3
check.yes(o:connect(i, policy))
for n = 1, 5 do o:write(n) end
for n = 1, 3 do check.equal(n, select(2, i:read())) end
check.equal("OldData", (i:read()))
check.yes(i:disconnect())
check.yes(i:connect(o, { type = 2, size = 2, init = true }))
for n = 1, 5 do o:write(n) end
check.equal(4, select(2, i:read()))
check.equal(5, select(2, i:read()))
check.yes(o:disconnect())
check.fails("", o.connect, o, i, { no_member = 1 })
check.fails("port", o.connect, o, 3)
check.no(o:connect(In("string", "text")))
check.no(o:connect(Out("int", "other")))

-- Structs; a sample is a copy.
local to, ti = Out("/sample/Tank", "to"), In("/sample/Tank", "ti")
to:connect(ti)
to:write({ id = 6, levels = { 1, 2 } })
local _, tank = ti:read()
check.equal(6, tank.id)
check.equal(2, tank.levels[1])
to:write({ id = 7 })
local _, later = ti:read()
check.equal(6, tank.id)
check.equal(7, later.id)

-- In components.
of.addPort(tc, o)
of.addPort(tc, i, "renamed", "Another text")
check.equal("renamed", i:info().name)
check.equal("Another text", of.getPort(tc, "renamed"):info().desc)
check.equal({ "o", "renamed" }, of.getPortNames(tc))
check.fails("no port 'i'", of.getPort, tc, "i")
check.fails("needs a name", of.addPort, tc, In("int"))
check.fails("only input ports", of.addEventPort, tc, Out("int", "e"))
of.removePort(tc, "renamed")
check.fails("no port 'renamed'", of.removePort, tc, "renamed")
check.equal({ "o" }, of.getPortNames(tc))
local known = of.getPort(tc, "o")
known:delete()
check.fails("deleted", o.write, o, 1)
check.fails("deleted", function() return known:info() end)
check.equal({}, of.getPortNames(tc))
i:delete()
check.has("deleted", tostring(i))

-- An event port starts updateHook of a component.
local zoo = of.getPeer(tc, "zoo")
local numbers, answers = Out("double", "numbers"), In("double", "answers")
check.yes(numbers:connect(of.getPort(zoo, "numbers_in")))
check.yes(answers:connect(of.getPort(zoo, "numbers_out")))
of.start(zoo)
check.soon(function()
   numbers:write(5)
   of.getOperation(zoo, "trigger")()
   return answers:read() == "NewData"
end)
check.equal(5, select(2, answers:read()))
of.stop(zoo)
check.fails("belongs to its component", function() of.getPort(zoo, "numbers_in"):delete() end)

-- Those of services.
local inner = of.provides(zoo, "inner")
check.equal({ "inner_out" }, inner:getPortNames())
check.equal("inner_out", inner:getPort("inner_out"):info().name)
check.fails("no port", inner.getPort, inner, "no_such_port")

check.fails("no typekit", In, "no_such_type")
check.fails("no typekit", Out, "no_such_type")
check.done()
