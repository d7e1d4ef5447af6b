-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- The application: rttlua deploy.lua
require("rttlib")
tc = rtt.getTC()
depl = tc:getPeer("Deployer")
depl:import("ocl")

-- create components
depl:loadComponent("producer", "OCL::LuaComponent")
depl:loadComponent("consumer", "OCL::LuaComponent")
-- ... and get references to them
producer = depl:getPeer("producer")
consumer = depl:getPeer("consumer")
-- what makes them a producer and a consumer
assert(producer:exec_file("producer.lua"))
assert(consumer:exec_file("consumer.lua"))
consumer:getProperty("factor"):set(10)

-- configure the components
assert(producer:configure())
assert(consumer:configure())
-- connect ports
cp = rtt.Variable("ConnPolicy", { type = 1, size = 100 })
assert(depl:connect("producer.outport", "consumer.inport", cp))
-- period in seconds, priority
depl:setActivity("producer", 0.01, 98, rtt.globals.ORO_SCHED_RT)
depl:setActivity("consumer", 0, 97, rtt.globals.ORO_SCHED_RT)
-- start components
assert(consumer:start())
assert(producer:start())

while consumer:received() < 3 do rtt.sleep(0.01) end
assert(producer:stop())
print(producer:getPort("outport"))
print("producer is " .. producer:getState() .. ", consumer is " .. consumer:getState())

-- rFSM is not part of the toolchain.
if pcall(require, "rfsm") then dofile("machine.lua") end
