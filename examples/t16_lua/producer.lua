-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Counts: one more in each cycle.
require("rttlib")
local tc = rtt.getTC()
local outport, counter

function configureHook()
   outport = rtt.OutputPort("int", "outport", "What was counted.")
   tc:addPort(outport)
   return true
end

function startHook()
   counter = 0
   return true
end

function updateHook()
   counter = counter + 1
   outport:write(counter)
end

function cleanupHook() rttlib.tc_cleanup() end
