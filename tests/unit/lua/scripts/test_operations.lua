-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Operations: call, send, collect.
local check = require("check")
local tc = rtt.getTC()
local of = rtt.TaskContext
local zoo = of.getPeer(tc, "zoo")
local function op(name) return of.getOperation(zoo, name) end
local V = rtt.Variable.new

local add = op("add")
check.equal(3, add(1, 2))
check.equal(3, rtt.Operation.call(add, 1, 2))
check.equal(3, add(V("double", 1), V("int", 2)))
check.equal(3, zoo:add(1, 2))
check.fails("takes 2 arguments, not 1", add, 1)
check.fails("takes 2 arguments, not 3", add, 1, 2, 3)
check.fails("argument 2: cannot make a double of a string", add, 1, "2")
check.equal(5, add(2, 3))

local name, doc, result, arity, arguments = add:info()
check.equal({ "add", "Adds", "double", 2 }, { name, doc, result, arity })
check.equal({ { name = "a", type = "double", desc = "one" }, { name = "b", type = "double", desc = "other" } },
   arguments)
check.equal("double add(double a, double b) // Adds", tostring(add))

-- Arguments by reference come back in Variables.
local number = V("double", 8)
check.equal(nil, op("halve")(number))
check.equal(4, number:tolua())
check.equal(nil, op("halve")(3))
local rest = V("int")
check.equal(3, op("divide")(17, 5, rest))
check.equal(2, rest:tolua())
local tank = V("/sample/Tank")
check.equal(1, zoo:fill(tank, 2.5))
check.equal(2, zoo:fill(tank, 3.5))
check.equal(3.5, tank.levels[1])
check.equal("Filling", tank.mode:toString())
check.equal(3, zoo:fill({ levels = { 1, 2 } }, 1))
check.equal("Draining", zoo:mode("Draining"):toString())

check.equal(nil, zoo:nothing())
check.fails("as asked", op("fail"))
check.fails("division by nothing", op("divide"), 1, 0, rest)
check.fails("no operation 'no_such'", of.getOperation, zoo, "no_such")
check.equal(nil, zoo.no_such)

-- Results of earlier calls stay.
local first = zoo:mode("Idle")
local second = zoo:mode("Filling")
check.equal("Idle", first:toString())
check.equal("Filling", second:toString())

-- send
local handle = op("greet"):send("you")
local status, text = handle:collect()
check.equal("SendSuccess", status)
check.equal("hello you", text)
local h = op("divide"):send(17, 5, 0)
local q, r = V("int"), V("int")
check.equal("SendSuccess", h:collect(q, r))
check.equal({ 3, 2 }, { q:tolua(), r:tolua() })
-- Any number of times, and with any kind of call.
status, q, r = h:collect()
check.equal({ "SendSuccess", 3, 2 }, { status, q, r })
status, q, r = h:collectIfDone()
check.equal({ "SendSuccess", 3, 2 }, { status, q, r })
check.fails("Variables are here", h.collect, h, V("int"))
check.fails("Variable", h.collect, h, 1, 2)
check.fails("takes 3 arguments", function() op("divide"):send(1) end)
check.equal("SendSuccess", (op("halve"):send(3):collect()))
local failed = op("divide"):send(1, 0, 0)
check.fails("division by nothing", failed.collect, failed)

-- Operations before methods only with rttlib.
check.equal("zoo", zoo:getName())

-- What was removed answers with an error.
local helloworld = "oneOf"
check.yes(tc:loadComponent(helloworld, "OCL::HelloWorld"))
local hello = of.getPeer(tc, helloworld)
local the_method = of.getOperation(hello, "the_method")
check.equal("Hello World", the_method())
check.yes(tc:unloadComponent(helloworld))
check.fails("", the_method)
check.fails("", of.getName, hello)
check.done()
