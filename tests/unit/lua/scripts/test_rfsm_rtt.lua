-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- rfsm_rtt with a stand-in for rFSM.
local check = require("check")
local rfsm = require("rfsm")
local rfsm_rtt = require("rfsm_rtt")
local tc = rtt.getTC()
local of = rtt.TaskContext

local out, into = rtt.OutputPort("string", "out"), rtt.InputPort("string", "into")
out:connect(into, { type = 1, size = 10 })
local number, numbers = rtt.OutputPort("int", "number"), rtt.InputPort("int", "numbers")
number:connect(numbers)

local read = rfsm_rtt.gen_read_str_events(into)
check.equal({}, read())
out:write("e_a")
out:write("e_b")
check.equal({ "e_a", "e_b" }, read())
check.equal({}, read())
local both = rfsm_rtt.gen_read_events(into, numbers)
out:write("e_c")
number:write(4)
check.equal({ "e_c", 4 }, both())
check.fails("type int, not string", rfsm_rtt.gen_read_str_events, numbers)
check.fails("not an InputPort", rfsm_rtt.gen_read_events, out)
check.fails("input ports", rfsm_rtt.gen_read_events)

local machine = rfsm.init({ initial = "closed", trans = { { src = "closed", tgt = "open", event = "e_open" },
   { src = "open", tgt = "closed", event = "e_close" } } })
local raise = rfsm_rtt.gen_raise_event(out, machine)
raise("e_open", "e_other")
check.equal({ "e_open", "e_other" }, read())
check.equal({ "e_open", "e_other" }, machine.queue)
rfsm_rtt.gen_raise_event(out)("e_x")
check.equal({ "e_x" }, read())
check.fails("OutputPort", rfsm_rtt.gen_raise_event, into)

rfsm.post_step_hook_add(machine, rfsm_rtt.gen_write_fqn(out))
check.equal({ "<none>" }, read())
rfsm.run(machine)
check.equal({ "root.open" }, read())
rfsm.run(machine)
check.equal({}, read())
rfsm.send_events(machine, "e_close")
rfsm.run(machine)
check.equal({ "root.closed" }, read())
local short = rfsm_rtt.gen_write_fqn(out, function(name) return name == "root.open" and "O" end)
local matching = rfsm_rtt.gen_write_fqn(out, "^root%.o")
read()
short(machine)
matching(machine)
check.equal({}, read())
rfsm.send_events(machine, "e_open")
rfsm.run(machine)
read()
short(machine)
matching(machine)
check.equal({ "O", "root.open" }, read())
check.fails("type string", rfsm_rtt.gen_write_fqn, number)

-- In the interpreter of another component, and in its engine.
local file = debug.getinfo(1, "S").source:match("^@(.*/)") .. "lib/door.lua"
for name, ee in pairs({ stepped = false, engine = true }) do
   check.yes(tc:loadComponent(name, "OCL::HelloWorld"))
   local host = of.getPeer(tc, name)
   check.yes(tc:setActivity(name, 0.002, 0, rtt.globals.ORO_SCHED_OTHER))
   check.yes(rfsm_rtt.service_launch_rfsm(file, host, ee))
   local events = rttlib.port_clone_conn(of.getPort(host, "door_events"))
   local state = rttlib.port_clone_conn(of.getPort(host, "door_state"))
   of.configure(host)
   of.start(host)
   events:write("e_open")
   if not ee then check.yes(of.provides(host, "Lua"):exec_str("require('rfsm').run(fsm)")) end
   check.soon(function() return select(2, state:read()) == "open" end)
   of.stop(host)
end
check.fails("cannot launch /no/such/file.lua", rfsm_rtt.service_launch_rfsm, "/no/such/file.lua", of.getPeer(tc, "zoo"))
check.done()
