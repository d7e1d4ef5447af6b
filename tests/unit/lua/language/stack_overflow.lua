-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local function endless(n) return 1 + endless(n + 1) end
local good, why = pcall(endless, 1)
print(good, (why:gsub("\n.*", "")))
print(loadstring("return " .. string.rep("(", 300) .. "1" .. string.rep(")", 300)))
