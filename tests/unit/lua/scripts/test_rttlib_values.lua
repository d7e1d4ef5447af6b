-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- rttlib: values and tables, short forms, texts of values.
local check = require("check")
local found = require("rttlib")
check.yes(found == rttlib)
check.yes(require("rttlib") == rttlib)
check.equal(false, rttlib.color)
local again = dofile(package.searchpath and "" or debug.getinfo(rttlib.rtt_type, "S").source:sub(2):gsub("/values", ""))
check.yes(again == rttlib)
check.equal(3, rtt.Variable("int", 3):tolua())

-- Constructors.
check.equal("Variable", rttlib.rtt_type(rtt.Variable("int", 3)))
check.equal("Property", rttlib.rtt_type(rtt.Property("int", "p", "d")))
check.equal("Attribute", rttlib.rtt_type(rtt.Attribute("int", "a")))
check.equal("InputPort", rttlib.rtt_type(rtt.InputPort("int", "i", "d")))
check.equal("OutputPort", rttlib.rtt_type(rtt.OutputPort("int", "o", "d")))
check.equal("EEHook", rttlib.rtt_type(rtt.EEHook("f")))
check.equal("TaskContext", rttlib.rtt_type(rtt.getTC()))
check.equal("table", rttlib.rtt_type({}))
check.equal("userdata", rttlib.rtt_type(io.stdout) == "FILE*" and "userdata" or "userdata")
check.equal(3, rtt.Variable.new("int", 3):tolua())
check.equal({ "p", "d" }, { rtt.Property("int", "p", "d"):info().name, rtt.Property("int", "p", "d"):info().desc })
check.fails("no typekit", function() rtt.Variable("no_such_type") end)

-- Globals.
check.equal(rtt.globals_get("ORO_SCHED_RT"), rtt.globals.ORO_SCHED_RT)
check.equal(nil, rtt.globals.no_such_global)
check.fails("cannot be assigned", function() rtt.globals.x = 1 end)

-- Tables.
local content = { id = 1, label = "n", position = { x = 1, y = 2 }, levels = { 1, 2, 3 }, path = { { x = 5, y = 0 } },
   weights = { 0, 0, 1 }, pair = { 3, 4 }, mode = "Draining", small = 7, flags = { true, false } }
local tank = rtt.Variable("/sample/Tank")
check.yes(tank:fromtab(content) == tank)
check.equal(content, tank:totab())
check.equal(content, rttlib.var2tab(tank))
check.equal({}, rtt.Variable("strings"):totab())
check.equal({ 1, 2, 3 }, rttlib.vect2tab(tank.levels))
check.equal({ { x = 5, y = 0 } }, rttlib.vect2tab(tank.path))
check.fails("no sequence", rttlib.vect2tab, tank)
check.fails("Variable", rttlib.vect2tab, 3)
check.equal(3, rttlib.var2tab(3))
check.equal("Filling", rttlib.var2tab(rtt.Variable("/sample/Mode", "Filling")))
rttlib.varfromtab(tank, { levels = { 9 } })
check.equal({ 9 }, tank.levels:totab())
check.equal("n", tank.label)
check.fails("'colour'", rttlib.varfromtab, tank, { colour = 1 })
check.fails("test_rttlib_values.lua:", function() rttlib.varfromtab(tank, { colour = 1 }) end)
check.fails("Variable", rttlib.varfromtab, {}, {})
check.equal("abc", rtt.Variable("rt_string", "abc"):totab())
local names = rtt.Property("strings", "names", "The names")
check.equal("b", rttlib.propfromtab(names, { "a", "b" })[1])
check.fails("Property", rttlib.propfromtab, tank, {})
local numbers = rtt.Attribute("ints", "numbers")
check.equal({ 4, 5 }, rttlib.attrfromtab(numbers, { 4, 5 }):get():totab())
check.fails("Attribute", rttlib.attrfromtab, names, {})

-- Policies.
local policy = rtt.Variable("ConnPolicy")
local types = { [-1] = "UNBUFFERED", [0] = "DATA", "BUFFER", "CIRCULAR_BUFFER" }
for number, name in pairs(types) do
   policy.type = number
   check.equal(name, rttlib.ConnPolicy2tab(policy).type)
end
local transports = { [0] = "default", "CORBA", "MQUEUE", "ROS" }
for number, name in pairs(transports) do
   policy.transport = number
   check.equal(name, rttlib.ConnPolicy2tab(policy).transport)
end
policy.transport, policy.name_id, policy.size = 7, "/chat", 4
local tab = rttlib.ConnPolicy2tab(policy)
check.equal({ 7, "/chat", 4, "LOCK_FREE", "PerConnection", false },
   { tab.transport, tab.name_id, tab.size, tab.lock_policy, tab.buffer_policy, tab.pull })
policy.lock_policy = 0
check.equal("UNSYNC", rttlib.ConnPolicy2tab(policy).lock_policy)
check.fails("ConnPolicy", rttlib.ConnPolicy2tab, tank)

-- Texts.
check.equal("3", rttlib.var2str(rtt.Variable("int", 3)))
check.equal("a b", rttlib.var2str(rtt.Variable("string", "a b")))
check.equal("{1,2}", rttlib.var2str(rtt.Variable("ints", { 1, 2 })))
check.equal('{x=1,y=2.5}', rttlib.var2str(rtt.Variable("/sample/Point", { x = 1, y = 2.5 })))
check.equal('{"a"}', tostring(rtt.Variable("strings", { "a" })))
check.equal("Filling", tostring(rtt.Variable("/sample/Mode", "Filling")))
check.equal("{1,2}", check.printed(rttlib.var_pp, rtt.Variable("ints", { 1, 2 })))
check.equal('names (strings) = {"a","b"} // The names', rttlib.prop2str(names))
check.equal('names (strings) = {"a","b"} // The names', tostring(names))
check.equal("numbers (ints) = {4,5}", tostring(numbers))
check.equal("SendHandle", tostring(rtt.getTC():getOperation("isRunning"):send()))
check.equal("EEHook", tostring(rtt.EEHook("f")))

rttlib.color = true
check.has("\27[", tostring(names))
check.has("names", tostring(names))
rttlib.color = false
check.no(tostring(names):find("\27"))
check.done()
