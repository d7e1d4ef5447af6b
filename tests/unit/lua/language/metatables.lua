-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local Vector = {}
Vector.__index = Vector
local function vector(x, y) return setmetatable({x = x, y = y}, Vector) end
Vector.__add = function(a, b) return vector(a.x + b.x, a.y + b.y) end
Vector.__unm = function(a) return vector(-a.x, -a.y) end
Vector.__eq = function(a, b) return a.x == b.x and a.y == b.y end
Vector.__lt = function(a, b) return a.x < b.x end
Vector.__le = function(a, b) return a.x <= b.x end
Vector.__tostring = function(a) return "(" .. a.x .. ", " .. a.y .. ")" end
Vector.__concat = function(a, b) return tostring(a) .. tostring(b) end
Vector.__call = function(a, factor) return vector(a.x * factor, a.y * factor) end
function Vector:length2() return self.x ^ 2 + self.y ^ 2 end
local a, b = vector(1, 2), vector(3, 4)
print(tostring(a + b), tostring(-a), a == vector(1, 2), a < b, a <= b, a > b)
print(a .. b, a .. "!", tostring(a(10)), b:length2())
print(getmetatable(a) == Vector, rawequal(a, vector(1, 2)), getmetatable("").__index == string)
