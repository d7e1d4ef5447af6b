-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Colours for terminals: ansicolors.red .. "text" .. ansicolors.reset, or ansicolors.red("text").
local codes = {
   reset = 0, clear = 0, bright = 1, dim = 2, underscore = 4, blink = 5, reverse = 7, hidden = 8,
   black = 30, red = 31, green = 32, yellow = 33, blue = 34, magenta = 35, cyan = 36, white = 37,
   onblack = 40, onred = 41, ongreen = 42, onyellow = 43, onblue = 44, onmagenta = 45, oncyan = 46, onwhite = 47,
}

local Code = {}
Code.__index = Code
Code.__tostring = function(code) return code.escape end
Code.__concat = function(a, b) return tostring(a) .. tostring(b) end
Code.__call = function(code, text) return code.escape .. tostring(text) .. "\27[0m" end

local ansicolors = {}
for name, number in pairs(codes) do
   ansicolors[name] = setmetatable({ escape = "\27[" .. number .. "m" }, Code)
end

return ansicolors
