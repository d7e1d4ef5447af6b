-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local weak = setmetatable({}, {__mode = "v"})
weak[1], weak[2] = {}, "text"
local keys = setmetatable({}, {__mode = "k"})
keys[{}] = 1
collectgarbage()
print(weak[1], weak[2], next(keys), collectgarbage("count") > 0)
do local p = newproxy(true); getmetatable(p).__gc = function() print("collected") end end
collectgarbage()
print(type(collectgarbage("count")), collectgarbage("setpause", 200), collectgarbage("stop"), collectgarbage("restart"))
local p = newproxy(true); getmetatable(p).__gc = function() print("at the end") end
