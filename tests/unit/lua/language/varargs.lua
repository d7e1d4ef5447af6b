-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local function f(...) return select("#", ...), ... end
print(f(), (f(1, nil, nil)))
print(f(nil, nil))
local function g(first, ...) local t = {n = select("#", ...), ...}; return first, t.n, t[1], t[2] end
print(g(1, 2, 3))
print(select(-1, 1, 2, 3), select(2, "a", "b", "c"))
print((f(1, 2)), #{f(1, 2)}, #{f(1, 2), f(1, 2)})
print(unpack({1, 2, 3}), unpack({1, 2, 3}, 2), unpack({1, 2}, 1, 3))
print(pcall(select, 0))
print(...)
