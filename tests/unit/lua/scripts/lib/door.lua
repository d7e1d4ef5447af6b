-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- A door as a machine.
require("rttlib")
local rfsm_rtt = require("rfsm_rtt")
local tc = rtt.getTC()
local events = rtt.InputPort("string", "door_events")
local state = rtt.OutputPort("string", "door_state")
tc:addPort(events)
tc:addPort(state)
door_state = state
return {
   initial = "closed",
   getevents = rfsm_rtt.gen_read_str_events(events),
   entered = function(name) state:write(name) end,
   trans = { { src = "closed", tgt = "open", event = "e_open" }, { src = "open", tgt = "closed", event = "e_close" } },
}
