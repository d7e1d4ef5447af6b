-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- The modules in the interpreter with memory of its own.
local check = require("check")
local tc = rtt.getTC()
local of = rtt.TaskContext
check.yes(tc:loadComponent("pooled", "OCL::LuaTLSFComponent"))
local pooled = of.getPeer(tc, "pooled")
check.yes(pooled:exec_str([[
   require("rttlib")
   require("rttros")
   require("rfsm_rtt")
   local tank = rtt.Variable("/sample/Tank")
   for i = 1, 100 do tank:fromtab({ id = i, levels = { 1, 2, i } }) end
   assert(tank:totab().levels[3] == 100)
   assert(rttlib.tc2str(rtt.getTC(), true):find("pooled", 1, true))
   collectgarbage()
]]))
check.yes(of.hasOperation(pooled, "tlsf_incmem"))
check.yes(pooled:tlsf_incmem(100000))
check.yes(of.loadService(tc, "LuaTLSF"))
check.yes(of.provides(tc, "LuaTLSF"):exec_str("assert(require('rttlib') == rttlib)"))
check.done()
