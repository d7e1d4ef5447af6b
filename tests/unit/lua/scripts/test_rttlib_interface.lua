-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- rttlib: interfaces from tables, cleaning up, connected ports.
local check = require("check")
require("rttlib")
local tc = rtt.getTC()
local of = rtt.TaskContext
local zoo = of.getPeer(tc, "zoo")
local attributes = #of.getAttributeNames(tc)

local iface = {
   ports = {
      { name = "a", datatype = "int", type = "in", desc = "In" },
      { name = "b", datatype = "string", type = "out" },
      { name = "c", datatype = "double", type = "in+event" },
   },
   properties = { { name = "p", datatype = "strings", desc = "Names" } },
   attributes = { { name = "n", datatype = "int" } },
}
local made = rttlib.create_if(iface)
check.equal({ "in", "out", "in" }, { made.ports.a:info().porttype, made.ports.b:info().porttype,
   made.ports.c:info().porttype })
check.equal("In", made.ports.a:info().desc)
check.equal({ name = "p", type = "strings", desc = "Names" }, made.props.p:info())
check.equal({ name = "n", type = "int" }, made.attrs.n:info())
check.yes(rttlib.tc_has_port(tc, "a"))
check.no(rttlib.tc_has_port(tc, "p"))
check.yes(rttlib.tc_has_property(tc, "p"))
check.no(rttlib.tc_has_property(tc, "a"))
check.yes(rttlib.tc_has_attribute(tc, "n"))
check.no(rttlib.tc_has_attribute(tc, "a"))

-- What there is stays.
made.props.p:set({ "kept" })
made.attrs.n:set(4)
local again = rttlib.create_if(iface)
check.equal("kept", again.props.p[0])
check.equal(4, again.attrs.n:get())
check.equal(attributes + 1, #of.getAttributeNames(tc))
check.equal(3, #of.getPortNames(tc))

check.fails("ports[1] needs a name", rttlib.create_if, { ports = { { datatype = "int", type = "in" } } })
check.fails("ports.x: ", rttlib.create_if, { ports = { { name = "x", datatype = "no_such_type", type = "in" } } })
check.fails("'in+event'", rttlib.create_if, { ports = { { name = "x", datatype = "int", type = "inout" } } })
check.equal({ ports = {}, props = {}, attrs = {} }, rttlib.create_if({}))

local properties, ports, others = rttlib.tc_cleanup()
check.equal({ 1, 3, 1 }, { properties, ports, others })
check.equal({}, of.getPortNames(tc))
check.equal(attributes, #of.getAttributeNames(tc))
check.no(rttlib.tc_has_property(tc, "p"))
check.fails("no longer", function() return made.ports.a:info() end)
properties, ports = rttlib.tc_cleanup()
check.equal({ 0, 0 }, { properties, ports })

-- A component of Lua keeps its own.
tc:loadComponent("own", "OCL::LuaComponent")
local own = of.getPeer(tc, "own")
local before = #of.getPropertyNames(own)
check.yes(own:exec_str([[
   require("rttlib")
   rttlib.create_if({ ports = {{ name = "x", datatype = "int", type = "in" }},
      properties = {{ name = "y", datatype = "int" }}, attributes = {{ name = "z", datatype = "int" }} })
   cleaned = { rttlib.tc_cleanup() }
   assert(cleaned[1] == 1 and cleaned[2] == 1 and cleaned[3] == 1)
]]))
check.equal(before, #of.getPropertyNames(own))
for _, name in ipairs({ "lua_string", "lua_file", "lua_timeout", "lua_gc_budget" }) do
   check.yes(rttlib.tc_has_property(own, name))
end
check.yes(rttlib.tc_has_attribute(own, "CycleCounter"))

-- Connected ports of the other direction.
local clone = rttlib.port_clone_conn(of.getPort(zoo, "numbers_in"))
check.equal({ "numbers_in_inv", "out", "double", true },
   { clone:info().name, clone:info().porttype, clone:info().type, clone:info().connected })
clone:write(4)
check.equal("NewData", (of.getPort(zoo, "numbers_in"):read()))
check.equal("numbers_outx", rttlib.port_clone_conn(of.getPort(zoo, "numbers_out"), "x"):info().name)
check.equal("me_tank_out_inv", rttlib.port_clone_conn(of.getPort(zoo, "tank_out"), nil, "me"):info().name)
local mirror = rttlib.mirror(zoo, "_mirrored")
check.equal("tank_in_mirrored", mirror.tank_in:info().name)
check.equal("in", mirror.numbers_out:info().porttype)
local count = 0
for _ in pairs(mirror) do count = count + 1 end
check.equal(#of.getPortNames(zoo), count)
local into = {}
check.yes(rttlib.mirror(zoo, nil, into) == into)
check.equal("tank_in_inv", into.tank_in:info().name)
check.done()
