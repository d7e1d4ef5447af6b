-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local function counter()
    local n = 0
    return function() n = n + 1; return n end, function() return n end
end
local next, now = counter()
local other = counter()
print(next(), next(), now(), other())
local all = {}
for i = 1, 3 do all[i] = function() i = i + 10; return i end end
print(all[1](), all[1](), all[2](), all[3]())
local f
do local hidden = "seen"; f = function() return hidden end end
print(f(), hidden)
