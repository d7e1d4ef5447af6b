-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- What scripts claim. All claims of a script are tried; `check.done()` at its end tells of those that failed.
local check = { failures = {} }

local function show(value)
   if type(value) == "string" then return string.format("%q", value) end
   return tostring(value)
end

local function fail(text)
   local place = debug.getinfo(3, "Sl")
   check.failures[#check.failures + 1] = place.short_src .. ":" .. place.currentline .. ": " .. text
end

local function same(a, b)
   if type(a) ~= "table" or type(b) ~= "table" then return a == b end
   for key, value in pairs(a) do
      if not same(value, b[key]) then return false end
   end
   for key in pairs(b) do
      if a[key] == nil then return false end
   end
   return true
end

local function text(value)
   if type(value) ~= "table" then return show(value) end
   local parts = {}
   for key, one in pairs(value) do parts[#parts + 1] = tostring(key) .. "=" .. text(one) end
   table.sort(parts)
   return "{" .. table.concat(parts, ",") .. "}"
end

function check.yes(value, what)
   if not value then fail((what or "this") .. " is " .. tostring(value)) end
end

function check.no(value, what)
   if value then fail((what or "this") .. " is " .. tostring(value)) end
end

--- Tables are compared by what is in them.
function check.equal(wanted, found)
   if not same(wanted, found) then fail("wanted " .. text(wanted) .. ", found " .. text(found)) end
end

function check.near(wanted, found)
   if type(found) ~= "number" or math.abs(wanted - found) > 1e-6 then
      fail("wanted about " .. show(wanted) .. ", found " .. show(found))
   end
end

--- The text has the other one in it, as it is.
function check.has(part, whole)
   if type(whole) ~= "string" or not whole:find(part, 1, true) then
      fail("wanted " .. show(part) .. " in " .. show(whole))
   end
end

--- The function fails, with that text in its error.
function check.fails(part, func, ...)
   local done, why = pcall(func, ...)
   if done then return fail("no error") end
   if not tostring(why):find(part, 1, true) then fail("wanted " .. show(part) .. " in error " .. show(why)) end
end

--- True within some seconds; others have work to do.
function check.soon(func)
   for _ = 1, 500 do
      if func() then return end
      rtt.sleep(0, 10000000)
   end
   fail("it did not happen")
end

--- What print() and io.stdout get while the function runs.
function check.printed(func, ...)
   local old, lines = print, {}
   print = function(...)
      local parts = {}
      for i = 1, select("#", ...) do parts[i] = tostring((select(i, ...))) end
      lines[#lines + 1] = table.concat(parts, "\t")
   end
   local done, why = pcall(func, ...)
   print = old
   if not done then fail(tostring(why)) end
   return table.concat(lines, "\n")
end

function check.done()
   if #check.failures > 0 then error("\n" .. table.concat(check.failures, "\n"), 0) end
end

return check
