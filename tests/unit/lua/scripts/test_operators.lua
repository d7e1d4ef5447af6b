-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Operators of Variables.
local check = require("check")
local V = rtt.Variable.new
local a, b = V("int", 7), V("int", 2)

check.equal(9, (a + b):tolua())
check.equal(5, (a - b):tolua())
check.equal(14, (a * b):tolua())
check.equal(3, (a / b):tolua())
check.equal(1, (a % b):tolua())
check.equal(-7, (-a):tolua())
check.equal(3.5, (V("double", 7) / V("double", 2)):tolua())
check.equal(true, a > b)
check.equal(true, b <= b)
check.equal(false, a < b)
check.equal(false, a == b)
check.equal(true, a == V("int", 7))
check.equal("ab", (V("string", "a") + V("string", "b")):tolua())
-- Values of Lua take part.
check.equal(8, (a + 1):tolua())
check.equal(8, (1 + a):tolua())

local R = rtt.Variable
check.equal(9, R.opBinary("+", a, b):tolua())
check.equal(true, R.opBinary("<", b, a):tolua())
for name, wanted in pairs({ add = 9, sub = 5, mul = 14, div = 3, mod = 1 }) do
   check.equal(wanted, R[name](a, b):tolua())
end
check.equal(-7, R.unm(a):tolua())
check.equal(false, R.eq(a, b))
check.equal(false, R.lt(a, b))
check.equal(false, R.le(a, b))
check.fails("there is no operator", R.opBinary, "nonsense", a, b)
check.fails("there is no operator", R.pow, V("string", "a"), V("string", "b"))
check.fails("there is no operator", function() return V("strings") + V("strings") end)
-- The operands stay.
check.equal(7, a:tolua())
check.done()
