-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local function third() print(debug.traceback("here")) end
local function second() third() end
function first() second() end
first()
print(debug.traceback("level 2", 2))
print(debug.traceback(coroutine.create(function() end), "other"))
print(select(2, xpcall(function() local x = nil + 1 end, debug.traceback)))
local info = debug.getinfo(1, "Sl")
print(info.short_src, info.currentline, info.what)
local depth = 0
while debug.getinfo(depth) do depth = depth + 1 end
print(depth, debug.getinfo(depth - 1, "S").what)
first = nil
local function deep(n) if n == 0 then error("deepest") end; deep(n - 1); return n end
deep(30)
