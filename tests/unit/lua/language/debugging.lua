-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local lines = {}
debug.sethook(function(_, line) lines[#lines + 1] = line end, "l")
local x = 1
x = x + 1
debug.sethook()
print(#lines, debug.gethook())
local function f(a, b) local c = 3; return debug.getlocal(1, 1), debug.getlocal(1, 3) end
print(f(1, 2))
local up = 5; local function g() return up end
print(debug.getupvalue(g, 1), debug.setupvalue(g, 1, 6), g())
print(debug.getinfo(print).what, debug.getinfo(f, "u").nups, debug.getinfo(f, "S").linedefined)
