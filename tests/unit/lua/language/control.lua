-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local n = 0
while true do n = n + 1; if n == 5 then break end end
repeat local last = n; n = n - 1 until last == 3
for i = 10, 1, -4 do io.write(i, " ") end
for i = 1, 0 do io.write("never") end
for i = 0.5, 2 do io.write(i, " ") end
print(n)
local a, b, c = (function() return 1, 2, 3 end)()
a, b = b, a
print(a, b, c, false or "default", nil and 1, 1 and 2, false == nil)
if n > 100 then print("big") elseif n > 1 then print("some") else print("none") end
do local a = "inner"; print(a) end
local t = {f = function(self, x) return self, x end}
print(select(2, t:f(5)), #{1, 2, 3, nil}, ("x"):rep(2))
for _, v in next, {1} do print(v) end
print(pcall(function() for i = 1, 10, "x" do end end))
