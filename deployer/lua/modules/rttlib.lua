-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- What makes the module `rtt` comfortable. The parts are in rttlib/, each with one subject.
local rttlib = { color = false }

-- Parts look at rttlib.color when they write.
package.loaded["rttlib"] = rttlib
for _, part in ipairs({ "values", "describe", "overview", "components", "interface", "help" }) do
   for name, func in pairs(require("rttlib." .. part)) do rttlib[name] = func end
end
require("rttlib.extend")(rttlib)

-- Scripts use it without keeping what require() returns.
_G.rttlib = rttlib
return rttlib
