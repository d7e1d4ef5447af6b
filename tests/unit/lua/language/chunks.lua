-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print(loadstring("return 1 + 1")())
print(loadstring("return +", "=name"))
print(loadstring("x = = 1", "@file.lua"))
print(loadstring("for", "some text"))
local pieces = {"return ", "4", "2"}
print(load(function() return table.remove(pieces, 1) end)())
print(loadfile("/no/such/file"))
print(pcall(dofile, "/no/such/file"))
local code = string.dump(function(x) return x * 2 end)
print(loadstring(code)(21))
local env = {print = print}
local f = loadstring("y = 3; print(y)"); setfenv(f, env); f()
print(env.y, y, getfenv(f) == env, getfenv(1) == _G, getfenv(0) == _G)
