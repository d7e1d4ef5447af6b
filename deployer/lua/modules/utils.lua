-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- A small library for texts, lists and programs.
local utils = {}

-- Texts --------------------------------------------------------------------------------------------------------------

--- The text with `fill` on its right until it has `width` letters. With `strip`, a longer one is cut.
function utils.rpad(text, width, fill, strip)
   text = tostring(text)
   if strip and #text > width then return text:sub(1, width) end
   return text .. (fill or " "):rep(width - #text)
end

--- The same with `fill` on its left.
function utils.lpad(text, width, fill, strip)
   text = tostring(text)
   if strip and #text > width then return text:sub(1, width) end
   return (fill or " "):rep(width - #text) .. text
end

--- The text with exactly `width` letters: cut, or filled on its right.
function utils.strsetlen(text, width, fill) return utils.rpad(text, width, fill, true) end

--- The text without white space at its ends.
function utils.trim(text) return (tostring(text):match("^%s*(.-)%s*$")) end

--- A list of what the separators separate; a separator is a pattern of Lua.
function utils.split(text, separator)
   separator = separator or "%s+"
   local parts, from = {}, 1
   while true do
      local first, last = text:find(separator, from)
      if not first or last < first then break end
      parts[#parts + 1] = text:sub(from, first - 1)
      from = last + 1
   end
   parts[#parts + 1] = text:sub(from)
   return parts
end

--- The words of a text in lines of at most `limit` letters. `indent` comes before each line, `first` before the first.
function utils.wrap(text, limit, indent, first)
   limit, indent = limit or 72, indent or ""
   local lines, line, empty = {}, first or indent, true
   for word in text:gmatch("%S+") do
      if not empty and #line + 1 + #word > limit then
         lines[#lines + 1] = line
         line, empty = indent, true
      end
      line = line .. (empty and "" or " ") .. word
      empty = false
   end
   lines[#lines + 1] = line
   return table.concat(lines, "\n")
end

--- The path of a file without its name, and the name without its folder.
function utils.dirname(path) return path:match("^(.*)/[^/]*$") or "." end
function utils.basename(path) return path:match("([^/]*)$") end

-- Tables -------------------------------------------------------------------------------------------------------------

local function key2str(key)
   if type(key) == "string" and key:match("^[%a_][%w_]*$") then return key end
   return "[" .. (type(key) == "string" and string.format("%q", key) or tostring(key)) .. "]"
end

-- Numbers come first, then texts, so that a table has one text only.
local function before(a, b)
   if type(a) == type(b) and (type(a) == "number" or type(a) == "string") then return a < b end
   if type(a) ~= type(b) then return type(a) < type(b) end
   return tostring(a) < tostring(b)
end

local function value2str(value, inside)
   if type(value) == "string" then return string.format("%q", value) end
   if type(value) ~= "table" then return tostring(value) end
   if inside[value] then return "{...}" end
   inside[value] = true
   local parts, keys = {}, {}
   for _, element in ipairs(value) do parts[#parts + 1] = value2str(element, inside) end
   local listed = #parts
   for key in pairs(value) do
      local isListed = type(key) == "number" and key >= 1 and key <= listed and key % 1 == 0
      if not isListed then keys[#keys + 1] = key end
   end
   table.sort(keys, before)
   for _, key in ipairs(keys) do parts[#parts + 1] = key2str(key) .. "=" .. value2str(value[key], inside) end
   inside[value] = nil
   return "{" .. table.concat(parts, ",") .. "}"
end

--- A table as Lua code in one line; other values as text. A table within itself becomes {...}.
function utils.tab2str(value) return value2str(value, {}) end

--- Prints values as tab2str() writes them.
function utils.pp(...)
   local texts = {}
   for i = 1, select("#", ...) do texts[i] = utils.tab2str((select(i, ...))) end
   print(table.concat(texts, "\t"))
end

--- A copy whose tables, and tables in them, are new ones. Metatables stay.
function utils.deepcopy(value)
   local known = {}
   local function copy(one)
      if type(one) ~= "table" then return one end
      if known[one] then return known[one] end
      local made = {}
      known[one] = made
      for key, element in pairs(one) do made[copy(key)] = copy(element) end
      return setmetatable(made, getmetatable(one))
   end
   return copy(value)
end

--- True if the tables have equal keys and values, also in the tables within.
function utils.table_cmp(a, b)
   if type(a) ~= "table" or type(b) ~= "table" then return a == b end
   for key, value in pairs(a) do
      if not utils.table_cmp(value, b[key]) then return false end
   end
   for key in pairs(b) do
      if a[key] == nil then return false end
   end
   return true
end

--- True if a list has the value.
function utils.table_has(list, value)
   for _, one in ipairs(list) do
      if one == value then return true end
   end
   return false
end

--- A list without what it has twice.
function utils.table_unique(list)
   local seen, made = {}, {}
   for _, one in ipairs(list) do
      if not seen[one] then
         seen[one] = true
         made[#made + 1] = one
      end
   end
   return made
end

--- The keys of a table, in order.
function utils.keys(tab)
   local made = {}
   for key in pairs(tab) do made[#made + 1] = key end
   table.sort(made, before)
   return made
end

-- Lists --------------------------------------------------------------------------------------------------------------

--- What `func(value, key)` gives for each value of a table, in a list; nil is left out.
function utils.map(func, tab)
   local made = {}
   for key, value in pairs(tab) do made[#made + 1] = func(value, key) end
   return made
end

--- The same for a list, in its order.
function utils.imap(func, list)
   local made = {}
   for index, value in ipairs(list) do made[#made + 1] = func(value, index) end
   return made
end

--- Calls `func(value, key)` for each value of a table.
function utils.foreach(func, tab)
   for key, value in pairs(tab) do func(value, key) end
end

--- The values of a list for which `func(value, index)` is true.
function utils.filter(func, list)
   local made = {}
   for index, value in ipairs(list) do
      if func(value, index) then made[#made + 1] = value end
   end
   return made
end

--- func(func(start, list[1]), list[2]) …
function utils.foldr(func, start, list)
   for _, value in ipairs(list) do start = func(start, value) end
   return start
end

--- True if `func` is true for all values, or for one.
function utils.andt(func, list)
   return utils.foldr(function(so, one) return so and func(one) and true or false end, true, list)
end
function utils.ort(func, list)
   return utils.foldr(function(so, one) return so or func(one) and true or false end, false, list)
end

--- A list of the elements of all lists given; what is no list counts as one element.
function utils.append(...)
   local made = {}
   for i = 1, select("#", ...) do
      local list = select(i, ...)
      if type(list) ~= "table" then list = { list } end
      for _, value in ipairs(list) do made[#made + 1] = value end
   end
   return made
end

--- A list without the lists in it: their elements are in their places.
function utils.flatten(list)
   local made = {}
   for _, value in ipairs(list) do
      if type(value) == "table" then
         for _, inner in ipairs(utils.flatten(value)) do made[#made + 1] = inner end
      else
         made[#made + 1] = value
      end
   end
   return made
end

-- Programs -----------------------------------------------------------------------------------------------------------

--- Writes its arguments without anything between or behind them.
function utils.write(...)
   for i = 1, select("#", ...) do io.stdout:write(tostring((select(i, ...)))) end
end

local function line(stream, ...)
   local texts = {}
   for i = 1, select("#", ...) do texts[i] = tostring((select(i, ...))) end
   stream:write(table.concat(texts, "\t"), "\n")
end

--- As print(), to either stream.
function utils.stdout(...) line(io.stdout, ...) end
function utils.stderr(...) line(io.stderr, ...) end

--- True if a file can be read.
function utils.file_exists(path)
   local file = io.open(path, "r")
   if file then file:close() end
   return file ~= nil
end

--- Options of a program: { "x", "-o", "a", "b", "-v" } gives { [0] = { "x" }, ["-o"] = { "a", "b" }, ["-v"] = {} }.
-- Numbers such as -1 are no options.
function utils.proc_args(arguments)
   local made = { [0] = {} }
   local current = made[0]
   for _, one in ipairs(arguments) do
      if type(one) == "string" and one:match("^%-") and one ~= "-" and not tonumber(one) then
         made[one] = made[one] or {}
         current = made[one]
      else
         current[#current + 1] = one
      end
   end
   return made
end

--- Calls `func` and gives its results, with an error that says `what` was tried.
function utils.try(what, func, ...)
   local results = { pcall(func, ...) }
   if not results[1] then error(what .. ": " .. tostring(results[2]), 2) end
   return unpack(results, 2)
end

return utils
