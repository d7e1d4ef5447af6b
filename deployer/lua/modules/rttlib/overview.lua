-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Texts of several lines: components and services with all that they have.
local describe = require("rttlib.describe")
local documented = require("rttlib.documented")
local paint = require("rttlib.paint")

local overview = {}

local function indented(lines, text, depth) lines[#lines + 1] = ("   "):rep(depth) .. text end

-- What services and components have in common. `of` is rtt.Service or rtt.TaskContext, whose functions no operation
-- hides.
local function members(lines, thing, of, depth)
   local function section(title, list)
      if #list == 0 then return end
      indented(lines, paint("title", title .. ":"), depth)
      for _, text in ipairs(list) do indented(lines, text, depth + 1) end
   end
   local function texts(list, func)
      local made = {}
      for i, one in ipairs(list) do made[i] = func(one) end
      return made
   end
   section("Properties", texts(of.getProperties(thing), describe.prop2str))
   section("Attributes", texts(of.getAttributes(thing), describe.attr2str))
   section("Ports", texts(of.getPortNames(thing), function(name) return describe.port2str(of.getPort(thing, name)) end))
   section("Operations", texts((of.getOps or of.getOperationNames)(thing), function(name)
      -- A type that no typekit knows is no reason to show none of the others.
      local known, text = pcall(function() return describe.op2str(of.getOperation(thing, name)) end)
      return known and text or name .. "(?)"
   end))
end

local function service(lines, one, depth)
   local doc = rtt.Service.doc(one)
   indented(lines, documented("Service " .. paint("name", rtt.Service.getName(one)), doc), depth)
   members(lines, one, rtt.Service, depth + 1)
   for _, name in ipairs(rtt.Service.getProviderNames(one)) do
      service(lines, rtt.Service.provides(one, name), depth + 1)
   end
end

--- A service with all that it has, and the services in it.
function overview.service2str(one)
   local lines = {}
   service(lines, one, 0)
   return table.concat(lines, "\n")
end

local function requester(lines, one, depth)
   local state = one:ready() and paint("good", "ready") or paint("bad", "not ready")
   indented(lines, "Requester " .. paint("name", one:getRequestName()) .. " [" .. state .. "]", depth)
   for _, name in ipairs(one:getOperationCallerNames()) do indented(lines, name, depth + 1) end
   for _, name in ipairs(one:getRequesterNames()) do requester(lines, one:requires(name), depth + 1) end
end

--- A service requester, its operation callers, and the requesters in it.
function overview.service_req2str(one)
   local lines = {}
   requester(lines, one, 0)
   return table.concat(lines, "\n")
end

--- A component: state, peers, properties, attributes, ports, operations; with `full` its services and requesters, too.
function overview.tc2str(tc, full)
   local of = rtt.TaskContext
   local lines = {}
   indented(lines, "TaskContext " .. paint("name", of.getName(tc)) .. " [" .. of.getState(tc) .. "]", 0)
   local peers = of.getPeers(tc)
   if #peers > 0 then indented(lines, paint("title", "Peers: ") .. table.concat(peers, ", "), 1) end
   members(lines, tc, of, 1)
   if full then
      for _, name in ipairs(of.getProviderNames(tc)) do service(lines, of.provides(tc, name), 1) end
      local required = of.requires(tc)
      for _, name in ipairs(required:getRequesterNames()) do requester(lines, required:requires(name), 1) end
   end
   return table.concat(lines, "\n")
end

--- Prints it.
function overview.pptc(tc, full) print(overview.tc2str(tc or rtt.getTC(), full)) end

return overview
