-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- What makes the module `rtt` comfortable. The parts are in rttlib/, each with one subject. A part is loaded when a script
-- first calls one of its functions, because each component has an interpreter, and memory, of its own.
local rttlib = { color = false }

local parts = {
   values = { "rtt_type", "var2tab", "vect2tab", "varfromtab", "propfromtab", "attrfromtab", "ConnPolicy2tab" },
   describe = { "var2str", "var_pp", "prop2str", "attr2str", "op2str", "tc_op2str", "port2str", "portval2str",
                "portstats" },
   overview = { "service2str", "service_req2str", "tc2str", "pptc" },
   components = { "mappeers", "findpeer", "stat", "tc_stat", "info", "typekit_loaded" },
   interface = { "tc_has_port", "tc_has_property", "tc_has_attribute", "create_if", "tc_cleanup", "port_clone_conn",
                 "mirror" },
   help = { "help" },
}

-- Parts look at rttlib.color when they write.
package.loaded["rttlib"] = rttlib
local stubs = {}
for part, names in pairs(parts) do
   for _, name in ipairs(names) do
      stubs[name] = function(...)
         local functions = require("rttlib." .. part)
         for known, func in pairs(functions) do
            -- A script may have put a function of its own there.
            if rttlib[known] == stubs[known] then rttlib[known] = func end
         end
         return functions[name](...)
      end
      rttlib[name] = stubs[name]
   end
end
require("rttlib.extend")(rttlib)

-- Scripts use it without keeping what require() returns.
_G.rttlib = rttlib
return rttlib
