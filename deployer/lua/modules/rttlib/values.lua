-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Values of C++ types and tables of Lua.
local values = {}

--- The name of the kind of userdata, such as "Variable"; of other values the type.
function values.rtt_type(x)
   local meta = type(x) == "userdata" and getmetatable(x)
   return type(meta) == "table" and rawget(meta, "__name") or type(x)
end

local function need(x, kind, func)
   if values.rtt_type(x) ~= kind then
      error(func .. ": this takes a " .. kind .. ", not a " .. values.rtt_type(x), 3)
   end
end

-- Sequences have no members but their size; the capacity is of those that grow.
local function isSequence(var, names)
   if var:getTypeName() == "rt_string" then return false end
   for _, name in ipairs(names) do
      if name ~= "size" and name ~= "capacity" then return false end
   end
   if names[1] == nil then return false end
   local size = var:getMember("size")
   return type(size) == "number" and (size == 0 or (pcall(var.getMemberRaw, var, 0)))
end

local toTable

local function elements(var)
   local made = {}
   for i = 0, var:getMember("size") - 1 do made[i + 1] = toTable(var:getMemberRaw(i)) end
   return made
end

function toTable(var)
   if var:isbasic() then return var:tolua() end
   local names = var:getMemberNames()
   if isSequence(var, names) then return elements(var) end
   if #names == 0 or var:getTypeName() == "rt_string" then
      if var:getTypeName() == "PropertyBag" then return {} end
      -- Enumerations and texts have a form to read; of other types there is nothing to see but "(type)".
      local text = var:toString()
      return text:match("^%(.*%)$") and var or text
   end
   local made = {}
   for _, name in ipairs(names) do made[name] = toTable(var:getMemberRaw(name)) end
   return made
end

--- A Variable as a table: members by name, elements of sequences from 1. Basic types become values of Lua,
-- enumerations their names; what has no parts stays a Variable. Values of Lua stay as they are.
function values.var2tab(var)
   if values.rtt_type(var) ~= "Variable" then return var end
   return toTable(var)
end

--- The elements of a sequence, from 1.
function values.vect2tab(var)
   need(var, "Variable", "vect2tab")
   if not isSequence(var, var:getMemberNames()) then
      error("vect2tab: type " .. var:getTypeName() .. " is no sequence", 2)
   end
   return elements(var)
end

--- Assigns a table to a Variable: members by name, elements of sequences from 1, which get the size of the table.
-- What the table does not name stays. A name that is no member is an error.
function values.varfromtab(var, tab)
   need(var, "Variable", "varfromtab")
   local done, why = pcall(var.assign, var, tab)
   if not done then error("varfromtab: " .. tostring(why), 2) end
   return var
end

--- The same for the value of a property or attribute.
function values.propfromtab(prop, tab)
   need(prop, "Property", "propfromtab")
   values.varfromtab(prop:getRaw(), tab)
   return prop
end

function values.attrfromtab(attr, tab)
   need(attr, "Attribute", "attrfromtab")
   values.varfromtab(attr:getRaw(), tab)
   return attr
end

local names = {
   type = { [-1] = "UNBUFFERED", [0] = "DATA", "BUFFER", "CIRCULAR_BUFFER" },
   lock_policy = { [0] = "UNSYNC", "LOCKED", "LOCK_FREE" },
   buffer_policy = { [0] = "UnspecifiedBufferPolicy", "PerConnection", "PerInputPort", "PerOutputPort", "Shared" },
   transport = { [0] = "default", "CORBA", "MQUEUE", "ROS" },
}

--- A ConnPolicy as a table with names in place of numbers. Transports without a name stay numbers.
function values.ConnPolicy2tab(policy)
   local made = values.var2tab(policy)
   if type(made) ~= "table" or made.lock_policy == nil then error("ConnPolicy2tab: this takes a ConnPolicy", 2) end
   for member, known in pairs(names) do made[member] = known[made[member]] or made[member] end
   return made
end

return values
