-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Prints the first numbers that come to its event port, each multiplied by a property.
require("rttlib")
local tc = rtt.getTC()
local inport
local received = 0

local factor = rtt.Property("int", "factor", "What each number is multiplied by.")
factor:set(1)
tc:addProperty(factor)
tc:addOperation("received", "int()", function() return received end, "How many numbers came.")

function configureHook()
   inport = rtt.InputPort("int", "inport", "The numbers.")
   tc:addEventPort(inport)
   return true
end

function updateHook()
   local status, number = inport:read()
   if status ~= "NewData" then return end
   received = received + 1
   if received <= 3 then print("received " .. number .. ", which makes " .. number * factor:get()) end
   io.flush()
end

function cleanupHook() rttlib.tc_cleanup() end
