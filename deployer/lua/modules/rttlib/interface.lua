-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Giving components ports, properties and attributes, and taking them away.
local interface = {}

-- An operation may have the name of any of these.
local of = rtt.TaskContext

local function has(names, wanted)
   for _, name in ipairs(names) do
      if name == wanted then return true end
   end
   return false
end

function interface.tc_has_port(tc, name) return has(of.getPortNames(tc), name) end
function interface.tc_has_property(tc, name) return has(of.getPropertyNames(tc), name) end
function interface.tc_has_attribute(tc, name) return has(of.getAttributeNames(tc), name) end

local function addPort(tc, entry)
   if entry.type == "in" then
      of.addPort(tc, rtt.InputPort.new(entry.datatype, entry.name, entry.desc))
   elseif entry.type == "in+event" then
      of.addEventPort(tc, rtt.InputPort.new(entry.datatype, entry.name, entry.desc))
   elseif entry.type == "out" then
      of.addPort(tc, rtt.OutputPort.new(entry.datatype, entry.name, entry.desc))
   else
      error("a port is of type 'in', 'in+event' or 'out', not '" .. tostring(entry.type) .. "'", 0)
   end
end

local function addProperty(tc, entry) of.addProperty(tc, rtt.Property.new(entry.datatype, entry.name, entry.desc)) end
local function addAttribute(tc, entry) of.addAttribute(tc, rtt.Attribute.new(entry.datatype, entry.name)) end

local kinds = {
   { list = "ports", into = "ports", has = interface.tc_has_port, add = addPort, get = of.getPort },
   { list = "properties", into = "props", has = interface.tc_has_property, add = addProperty, get = of.getProperty },
   { list = "attributes", into = "attrs", has = interface.tc_has_attribute, add = addAttribute, get = of.getAttribute },
}

--- Makes what a table describes, in the component of this code unless `tc` is another one:
-- { ports = {{ name=, datatype=, type='in'|'out'|'in+event', desc= }}, properties = {{ name=, datatype=, desc= }},
-- attributes = {{ name=, datatype= }} }. What has such a name already stays as it is.
-- Gives { ports = {}, props = {}, attrs = {} }, by name.
function interface.create_if(iface, tc)
   tc = tc or rtt.getTC()
   local made = {}
   for _, kind in ipairs(kinds) do
      made[kind.into] = {}
      for i, entry in ipairs(iface[kind.list] or {}) do
         if type(entry.name) ~= "string" or type(entry.datatype) ~= "string" then
            error("create_if: " .. kind.list .. "[" .. i .. "] needs a name and a datatype", 2)
         end
         if not kind.has(tc, entry.name) then
            local done, why = pcall(kind.add, tc, entry)
            if not done then error("create_if: " .. kind.list .. "." .. entry.name .. ": " .. tostring(why), 2) end
         end
         made[kind.into][entry.name] = kind.get(tc, entry.name)
      end
   end
   return made
end

-- Only Lua code deletes what Lua code made; all else belongs to the component and stays, such as lua_file.
local function deleteAll(tc, names, get)
   local number = 0
   for _, name in ipairs(names) do
      local thing = get(tc, name)
      if pcall(thing.delete, thing) then number = number + 1 end
   end
   return number
end

--- Removes and deletes the ports, properties and attributes that Lua code gave to its component. How many properties,
-- ports and attributes these were.
function interface.tc_cleanup()
   local tc = rtt.getTC()
   local ports = deleteAll(tc, of.getPortNames(tc), of.getPort)
   local properties = deleteAll(tc, of.getPropertyNames(tc), of.getProperty)
   local attributes = deleteAll(tc, of.getAttributeNames(tc), of.getAttribute)
   return properties, ports, attributes
end

--- A port of the other direction that is connected to the given one. Its name ends in `suffix` ("_inv") and begins with
-- `cname`, if that is given.
function interface.port_clone_conn(port, suffix, cname)
   local info = port:info()
   local make = info.porttype == "in" and rtt.OutputPort.new or rtt.InputPort.new
   local name = (cname and cname .. "_" or "") .. info.name .. (suffix or "_inv")
   local clone = make(info.type, name, "Inverse of port " .. (cname and cname .. "." or "") .. info.name)
   if not port:connect(clone) then
      clone:delete()
      error("port_clone_conn: port '" .. info.name .. "' cannot be connected; see the log", 2)
   end
   return clone
end

--- Such ports for all ports of a component, by the names of its ports; they are put into `tab`, if that is given.
function interface.mirror(comp, suffix, tab)
   tab = tab or {}
   for _, name in ipairs(of.getPortNames(comp)) do
      tab[name] = interface.port_clone_conn(of.getPort(comp, name), suffix)
   end
   return tab
end

return interface
