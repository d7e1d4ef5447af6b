-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- rttlib: finding components, and how they are.
local check = require("check")
require("rttlib")
local tc = rtt.getTC()
local of = rtt.TaskContext

tc:loadComponent("far", "OCL::LuaComponent")
tc:loadComponent("near", "OCL::LuaComponent")
tc:addPeer("near", "far")
local far, near = of.getPeer(tc, "far"), of.getPeer(tc, "near")
-- Circles and aliases do no harm.
of.addPeer(far, tc)
of.addPeer(far, near, "alias")
check.yes(rttlib.findpeer("far") == far)
check.yes(rttlib.findpeer("far", near) == far)
check.yes(rttlib.findpeer("near", near) == near)
check.yes(rttlib.findpeer("Deployer") == tc)
check.equal(false, rttlib.findpeer("nobody"))
local names = rttlib.mappeers(function(one) return of.getName(one) end)
table.sort(names)
check.equal({ "Deployer", "far", "near", "zoo" }, names)
check.equal({ "far" }, rttlib.mappeers(function(one) if one == far then return "far" end end, near))

local rows
local text = check.printed(function() rows = rttlib.stat() end)
check.has("zoo", text)
check.has("PreOperational", text)
local row
for _, one in ipairs(rows) do row = one.name == "zoo" and one or row end
check.equal({ "Stopped", false, true }, { row.state, row.isRunning, row.isActive })
check.equal("number", type(row.period))
check.has("near", check.printed(function() near:stat() end))

local known
text = check.printed(function() known = rttlib.info() end)
check.has("typekits: ", text)
check.equal(#rtt.types(), #known.types)
check.yes(rttlib.typekit_loaded("rtt-types"))
check.no(rttlib.typekit_loaded("no-such-typekit"))
check.done()
