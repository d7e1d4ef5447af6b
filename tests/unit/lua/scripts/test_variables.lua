-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Variables of basic types: values, ranges, conversions.
local check = require("check")
local V = rtt.Variable.new

local ranges = {
   int8 = { -128, 127 }, uint8 = { 0, 255 }, int16 = { -32768, 32767 }, uint16 = { 0, 65535 },
   int = { -2 ^ 31, 2 ^ 31 - 1 }, uint = { 0, 2 ^ 32 - 1 }, int64 = { -2 ^ 53, 2 ^ 53 }, uint64 = { 0, 2 ^ 53 },
   int32 = { -2 ^ 31, 2 ^ 31 - 1 }, uint32 = { 0, 2 ^ 32 - 1 }, long = { -2 ^ 53, 2 ^ 53 }, ulong = { 0, 2 ^ 53 },
   llong = { -2 ^ 53, 2 ^ 53 }, ullong = { 0, 2 ^ 53 },
}
for type, range in pairs(ranges) do
   for _, value in ipairs(range) do
      check.equal(value, V(type, value):tolua())
   end
   check.equal(0, V(type):tolua())
   if range[2] < 2 ^ 53 then
      check.fails("cannot hold", V, type, range[2] + 1)
      check.fails("cannot hold", V, type, range[1] - 1)
   end
   check.fails("cannot make a", V, type, "1")
   check.fails("cannot make a", V, type, true)
end
check.equal(1, V("int", 1.9):tolua())
check.equal(-1, V("int", -1.9):tolua())
check.fails("cannot hold", V, "int", 0 / 0)
check.fails("cannot hold", V, "int64", 2 ^ 64)

check.equal(0.1, V("double", 0.1):tolua())
check.near(0.1, V("float", 0.1):tolua())
check.equal(1 / 0, V("double", 1 / 0):tolua())

check.equal(true, V("bool", true):tolua())
check.equal(false, V("bool"):tolua())
check.equal(false, V("bool", 0):tolua())
check.equal(true, V("bool", 2):tolua())
check.fails("cannot make a bool", V, "bool", "true")

check.equal("x", V("char", "x"):tolua())
check.equal("", V("char"):tolua())
check.equal("", V("char", ""):tolua())
check.fails("2 letters", V, "char", "xy")

check.equal("text", V("string", "text"):tolua())
check.equal("a\0b", V("string", "a\0b"):tolua())
check.fails("cannot make a string", V, "string", 1)

check.equal("abc", V("rt_string", "abc"):toString())

check.equal(4, rtt.Variable("int", 4):tolua())
check.fails("test_variables.lua:", function() local made = rtt.Variable("no_such_type") return made end)
check.fails("no typekit", V, "no_such_type")
check.fails("void", V, "void")
check.fails("string", V)
check.equal(5, V("int", V("int", 5)):tolua())

local i = V("int", 7)
check.yes(i:isbasic())
check.equal("7", i:toString())
check.equal("int", i:getTypeName())
check.has("int", i:getType())
check.equal("i", i:getTypeIdName())
check.equal({}, i:getMemberNames())
check.equal("userdata", type(i:tolud()))
check.yes(#rtt.Variable.getTypes() == #rtt.types())
i:assign(8)
check.equal(8, i:tolua())
i:assign(V("int", 9))
check.equal(9, i:tolua())
check.fails("cannot make a int of a string", i.assign, i, "9")
check.fails("cannot be assigned", i.assign, i, V("string", "9"))
check.fails("", i.assign, i)
check.no(i:resize(3))
local d = V("double")
d:assign(V("int", 4))
check.equal(4, d:tolua())

-- Another kind of userdata, and none.
check.fails("Variable", i.tolua, rtt.getTC())
check.fails("Variable", i.tolua)
check.fails("Variable", i.tolua, 3)
check.done()
