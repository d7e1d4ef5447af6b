-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- A lamp as a state machine of rFSM, whose events come from a port.
local rfsm = require("rfsm")
local rfsm_rtt = require("rfsm_rtt")

local seen = {}
local function lamp(name)
   return rfsm.state { entry = function() seen[#seen + 1] = name end }
end

local machine = rfsm.init(rfsm.state {
   initial = rfsm.conn {},
   off = lamp("off"),
   on = lamp("on"),
   rfsm.trans { src = "initial", tgt = "off" },
   rfsm.trans { src = "off", tgt = "on", events = { "e_on" } },
   rfsm.trans { src = "on", tgt = "off", events = { "e_off" } },
})

local button = rtt.OutputPort("string", "button")
local events = rtt.InputPort("string", "events")
button:connect(events, { type = 1, size = 10 })
machine.getevents = rfsm_rtt.gen_read_str_events(events)

rfsm.run(machine)
button:write("e_on")
rfsm.run(machine)
button:write("e_off")
rfsm.run(machine)
assert(table.concat(seen, " ") == "off on off", "the lamp was " .. table.concat(seen, " "))
