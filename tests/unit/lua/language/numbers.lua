-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print(1, 1.0, -0.0 == 0, 1e15, 1e16, 1e100, 0.1, 1 / 3, 123456789012345, 2 ^ 53)
print(1 / 0, -1 / 0, 5 % 3, -5 % 3, 5 % -3, 5.5 % 2, 2 ^ 0.5, 7 / 2)
print(0xff, 1e2, .5, 3., tonumber("0x1p4"), tonumber("  12  "), tonumber("1e1"), tonumber("z", 36), tonumber("8", 8))
print(math.floor(-3.5), math.ceil(-3.5), math.abs(-3), math.max(1, 5, 3), math.min(2, 0), math.fmod(-5, 3), math.modf(3.7))
print(math.huge, -math.huge, string.format("%.14g %.3f %e %g", math.pi, math.pi, 12345.678, 1e20))
print(math.sin(0), math.cos(0), math.sqrt(16), math.exp(0), math.log(1), math.log10(1000), math.ldexp(1, 4), math.frexp(8))
print(1 == 1.0, "1" == 1, 0 == -0, 1 < 2, not nil, not 0, nil == false)
math.randomseed(1); local r = math.random(10); print(r >= 1 and r <= 10, pcall(math.random, 0))
