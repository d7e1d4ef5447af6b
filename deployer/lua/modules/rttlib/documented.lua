-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local paint = require("rttlib.paint")

--- The text with its description behind it, if there is one.
return function(text, doc)
   if doc == nil or doc == "" then return text end
   return text .. paint("doc", " // " .. doc)
end
