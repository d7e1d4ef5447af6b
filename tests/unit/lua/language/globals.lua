-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local names = {}
for name in pairs(_G) do if name ~= "rtt" and name ~= "arg" and name ~= "tlsf" then names[#names + 1] = name end end
table.sort(names); print(table.concat(names, " "))
for _, library in ipairs({"string", "table", "math", "io", "os", "coroutine", "debug", "package"}) do
    names = {}
    for name in pairs(_G[library]) do names[#names + 1] = name end
    table.sort(names); print(library, table.concat(names, " "))
end
print(_VERSION, _G._G == _G, type(nil), type(print), type({}), type(""), type(2), type(coroutine.create(function() end)))
