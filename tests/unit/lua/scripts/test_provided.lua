-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Operations that Lua functions execute.
local check = require("check")
local tc = rtt.getTC()
local of = rtt.TaskContext
local V = rtt.Variable.new

tc:addOperation("plus", "double(double a, double b)", function(a, b) return a + b end, "Adds in Lua")
check.equal(5, of.getOperation(tc, "plus")(2, 3))
check.equal("double plus(double a, double b) // Adds in Lua", tostring(of.getOperation(tc, "plus")))
check.equal(7, tc:plus(3, 4))
-- The same name again replaces it.
tc:addOperation("plus", "double(double a, double b)", function(a, b) return a + b + 1 end)
check.equal(8, of.getOperation(tc, "plus")(3, 4))

-- New values of arguments by reference follow the result.
tc:addOperation("split", "int(double x, int& whole, double& rest)", function(x)
   return 1, math.floor(x), x - math.floor(x)
end)
local whole, rest = V("int"), V("double")
check.equal(1, of.getOperation(tc, "split")(2.5, whole, rest))
check.equal({ 2, 0.5 }, { whole:tolua(), rest:tolua() })

tc:addOperation("long", "long(int32 a, const std::string& b)", function(a, b) return a + #b end)
check.equal(5, of.getOperation(tc, "long")(2, "abc"))
tc:addOperation("nothing", "void()", function() end)
check.equal(nil, of.getOperation(tc, "nothing")())
tc:addOperation("bad", "int()", function() return "text" end)
check.fails("its result: cannot make a int of a string", of.getOperation(tc, "bad"))
tc:addOperation("broken", "int()", function() error("in Lua") end, { doc = "Fails" })
check.fails("in Lua", of.getOperation(tc, "broken"))
tc:addOperation("two", "int()", function() end)
check.fails("returns nothing", of.getOperation(tc, "two"))

check.fails("signature", of.addOperation, tc, "x", "no signature", print)
check.fails("type of", of.addOperation, tc, "x", "int(no_such_type a)", print)
check.fails("function", of.addOperation, tc, "x", "int()", 3)
check.fails("ClientThread", of.addOperation, tc, "x", "int()", print, { thread = "Nowhere" })
check.fails("already", of.addOperation, tc, "import", "int()", print)
of.removeOperation(tc, "plus")
check.no(of.hasOperation(tc, "plus"))
check.fails("no Lua code gave", of.removeOperation, tc, "plus")
check.fails("no Lua code gave", of.removeOperation, tc, "import")

-- In a component with a thread of its own, called by others.
check.yes(tc:loadComponent("server", "OCL::LuaComponent"))
local server = of.getPeer(tc, "server")
check.yes(tc:setActivity("server", 0, 0, rtt.globals_get("ORO_SCHED_OTHER")))
check.yes(server:exec_str([[
   local tc = rtt.getTC()
   tc:addOperation("double_own", "double(double x)", function(x) return 2 * x end, { thread = "OwnThread" })
   tc:addOperation("double_client", "double(double x)", function(x) return 2 * x end)
   tc:addOperation("fill", "void(/sample/Tank& tank)", function(tank)
      tank.id = tank.id + 3
      tank:assign({ levels = { 1, 2 } })
      return tank
   end, { thread = "OwnThread" })
   tc:addOperation("failing", "int()", function() error("deep inside") end, { thread = "OwnThread" })
]]))
check.yes(of.configure(server) and of.start(server))
check.equal(6, server:double_own(3))
check.equal(6, server:double_client(3))
local tank = V("/sample/Tank")
server:fill(tank)
check.equal({ 3, 2 }, { tank.id, tank.levels[1] })
check.equal(12, select(2, of.getOperation(server, "double_own"):send(6):collect()))
check.fails("deep inside", of.getOperation(server, "failing"))
-- Both ways at once: the server calls the one that waits for it.
of.addPeer(server, tc)
tc:addOperation("ask_back", "double(double x)", function(x) return x + 1 end)
check.yes(server:exec_str([[
   local tc = rtt.getTC()
   tc:addOperation("round", "double(double x)", function(x)
      return rtt.TaskContext.getPeer(tc, "Deployer"):ask_back(x)
   end, { thread = "OwnThread" })
]]))
check.equal(4, server:round(3))
check.done()
