-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Texts that describe variables, ports, operations, services.
local documented = require("rttlib.documented")
local paint = require("rttlib.paint")
local values = require("rttlib.values")
local tab2str = require("utils").tab2str

local describe = {}

-- Basic values stand alone as they are; within tables, texts have quotes.
local function value2str(value)
   if type(value) == "table" then return tab2str(values.var2tab(value)) end
   if values.rtt_type(value) == "Variable" then
      local tab = values.var2tab(value)
      if type(tab) == "table" then return tab2str(tab) end
      return values.rtt_type(tab) == "Variable" and tab:toString() or tostring(tab)
   end
   return tostring(value)
end

--- The value of a Variable as text: {x=1,y=2}, or {1,2} for sequences.
function describe.var2str(var) return value2str(var) end

--- Prints it.
function describe.var_pp(var) print(value2str(var)) end

local function valueOf(holder)
   local known, value = pcall(holder.getRaw, holder)
   return known and value2str(value) or "?"
end

--- `name (type) = value // description`
function describe.prop2str(prop)
   local info = prop:info()
   local text = paint("name", info.name) .. " (" .. paint("type", info.type) .. ") = " .. paint("value", valueOf(prop))
   return documented(text, info.desc)
end

--- `name (type) = value`
function describe.attr2str(attr)
   local info = attr:info()
   return paint("name", info.name) .. " (" .. paint("type", info.type) .. ") = " .. paint("value", valueOf(attr))
end

local function signature(name, doc, result, arguments)
   local parts = {}
   for i, one in ipairs(arguments) do
      parts[i] = paint("type", one.type) .. (one.name ~= "" and " " .. one.name or "")
   end
   local text = paint("type", result) .. " " .. paint("name", name) .. "(" .. table.concat(parts, ", ") .. ")"
   return documented(text, doc)
end

--- `result name(type argument, …) // description`
function describe.op2str(op)
   local name, doc, result, _, arguments = op:info()
   return signature(name, doc, result, arguments)
end

--- The same for an operation of a component or service, by name.
function describe.tc_op2str(tc, name)
   local of = values.rtt_type(tc) == "Service" and rtt.Service or rtt.TaskContext
   local doc, result, _, arguments = of.getOperationInfo(tc, name)
   return signature(name, doc, result, arguments)
end

--- `name [in, type, conn, local] // description`
function describe.port2str(port, nodoc)
   local info = port:info()
   local text = paint("name", info.name) .. " [" .. table.concat({
      info.porttype, paint("type", info.type), info.connected and paint("good", "conn") or "unconn",
      info.isLocal and "local" or "nonlocal" }, ", ") .. "]"
   return nodoc and text or documented(text, info.desc)
end

--- The value that a port has now. That of an output port is what the operation `last` of its service in `comp` gives.
-- Reading an input port takes the sample from the component.
function describe.portval2str(port, comp)
   local info = port:info()
   if info.porttype == "in" then
      local status, value = port:read()
      return status == "NoData" and "NoData" or value2str(value)
   end
   comp = comp or rtt.getTC()
   local found, last = pcall(function() return rtt.TaskContext.provides(comp, info.name):getOperation("last") end)
   if not found then return "?" end
   local read, value = pcall(last)
   return read and value2str(value) or "?"
end

--- Prints all ports of a component with their values.
function describe.portstats(tc)
   tc = tc or rtt.getTC()
   for _, name in ipairs(rtt.TaskContext.getPortNames(tc)) do
      local port = rtt.TaskContext.getPort(tc, name)
      -- Samples that wait belong to the component.
      local value = port:info().porttype == "out" and " = " .. paint("value", describe.portval2str(port, tc)) or ""
      print(describe.port2str(port, true) .. value)
   end
end

return describe
