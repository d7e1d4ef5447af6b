-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Texts in colour, as long as rttlib.color is set.
local ansicolors = require("ansicolors")

local colours = {
   name = { "bright", "blue" }, type = { "magenta" }, value = { "cyan" }, doc = { "red" },
   title = { "bright" }, good = { "green" }, bad = { "bright", "red" },
}

--- The text in the colour of what it is.
return function(what, text)
   text = tostring(text)
   if not package.loaded["rttlib"].color then return text end
   local start = ""
   for _, code in ipairs(colours[what]) do start = start .. ansicolors[code] end
   return start .. text .. ansicolors.reset
end
