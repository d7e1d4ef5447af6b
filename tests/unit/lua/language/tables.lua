-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local t = {5, 2, 8, 1}
table.sort(t); print(table.concat(t, " "))
table.sort(t, function(a, b) return a > b end); print(table.concat(t, ", ", 2, 3))
table.insert(t, 9); table.insert(t, 1, 0); print(table.concat(t, " "), table.remove(t), table.remove(t, 1), #t)
print(table.maxn({1, 2, [10] = 3}), table.getn({1, 2}), next({}), #{n = 1})
local keys = {}
for k in pairs({a = 1, b = 2, c = 3}) do keys[#keys + 1] = k end
table.sort(keys); print(unpack(keys))
for i, v in ipairs({1, 2, nil, 4}) do io.write(i, "=", v, " ") end
print()
table.foreachi({"x", "y"}, print)
print(pcall(table.concat, {1, {}, 3}), pcall(table.sort, {1, "x"}), pcall(next, {}, "none"))
