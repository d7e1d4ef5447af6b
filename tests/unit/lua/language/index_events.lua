-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local reads = {}
local proxy = setmetatable({}, {
    __index = function(_, key) reads[#reads + 1] = key; return key .. "?" end,
    __newindex = function(t, key, value) rawset(t, key, value * 2) end})
print(proxy.a, proxy.b)
proxy.a = 21
print(proxy.a, rawget(proxy, "c"), table.concat(reads, " "))
local base = setmetatable({deep = "base"}, {__index = {deeper = "ground"}})
local top = setmetatable({}, {__index = base})
print(top.deep, top.deeper, top.none)
print(pcall(setmetatable, setmetatable({}, {__metatable = "locked"}), {}))
print(getmetatable(setmetatable({}, {__metatable = "locked"})))
