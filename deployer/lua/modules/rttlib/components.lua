-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Which components there are, and how they are.
local paint = require("rttlib.paint")
local rpad = require("utils").rpad

local components = {}

-- Operations of the component or, of another process, those that it shows.
local function ask(tc, operation)
   if not rtt.TaskContext.hasOperation(tc, operation) then return nil end
   local answered, value = pcall(function() return rtt.TaskContext.getOperation(tc, operation)() end)
   if answered then return value end
end

--- Calls `func(component)` for a component, its peers, their peers …, each once. Gives a list of the results that are
-- not nil. Without `start` that is the component of this code.
function components.mappeers(func, start)
   local results, seen, waiting = {}, {}, { start or rtt.getTC() }
   seen[rtt.TaskContext.getName(waiting[1])] = true
   local at = 1
   while waiting[at] do
      local tc = waiting[at]
      at = at + 1
      results[#results + 1] = func(tc)
      for _, name in ipairs(rtt.TaskContext.getPeers(tc)) do
         -- A peer of another name may be one that was seen; one that was just destroyed is none.
         local known, peer = pcall(rtt.TaskContext.getPeer, tc, name)
         local own = known and rtt.TaskContext.getName(peer)
         if own and not seen[own] then
            seen[own] = true
            waiting[#waiting + 1] = peer
         end
      end
   end
   return results
end

--- The component of that name among a component, its peers, their peers …; false if there is none.
function components.findpeer(name, start)
   local found = false
   components.mappeers(function(tc)
      if rtt.TaskContext.getName(tc) == name then found = found or tc end
   end, start)
   return found
end

local function stateOf(tc)
   return {
      name = rtt.TaskContext.getName(tc), state = rtt.TaskContext.getState(tc), isActive = ask(tc, "isActive"),
      isRunning = ask(tc, "isRunning"), isConfigured = ask(tc, "isConfigured"), period = ask(tc, "getPeriod"),
      inFatalError = ask(tc, "inFatalError"), inRunTimeError = ask(tc, "inRunTimeError"),
      inException = ask(tc, "inException"),
   }
end

local widths = { { "name", 24 }, { "state", 16 }, { "isActive", 10 }, { "isRunning", 11 }, { "period", 10 } }

local function line(cell)
   local text = ""
   for _, column in ipairs(widths) do text = text .. rpad(cell(column[1]), column[2]) end
   return (text:gsub("%s+$", ""))
end

local function show(rows)
   print(paint("title", line(function(name) return name end)))
   for _, row in ipairs(rows) do
      local bad = row.state == "FatalError" or row.state == "Exception" or row.state == "RunTimeError"
      local text = line(function(name) return row[name] == nil and "?" or tostring(row[name]) end)
      print(bad and paint("bad", text) or text)
   end
end

--- Prints a table of all components, and gives it: a list of { name=, state=, isActive=, isRunning=, period=, … }.
function components.stat(start)
   local rows = components.mappeers(stateOf, start)
   show(rows)
   return rows
end

--- The same for one component.
function components.tc_stat(tc)
   local row = stateOf(tc)
   show({ row })
   return row
end

--- Prints which services, typekits and types are loaded, and gives them as { services=, typekits=, types= }.
function components.info()
   local known = { services = rtt.services(), typekits = rtt.typekits(), types = rtt.types() }
   for _, what in ipairs({ "services", "typekits", "types" }) do
      print(paint("title", what .. ":") .. " " .. table.concat(known[what], ", "))
   end
   return known
end

--- True if a typekit of that name is loaded.
function components.typekit_loaded(name)
   for _, known in ipairs(rtt.typekits()) do
      if known == name then return true end
   end
   return false
end

return components
