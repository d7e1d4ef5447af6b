-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local composite, primes = {}, {}
for i = 2, 100 do
    if not composite[i] then
        primes[#primes + 1] = i
        for j = i * i, 100, i do composite[j] = true end
    end
end
print(#primes, table.concat(primes, " "))
