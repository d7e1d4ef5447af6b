-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print(#arg, arg[0] ~= nil, arg[1], arg[2], arg[3], ...)
arg = nil
print(arg, select("#", ...))
