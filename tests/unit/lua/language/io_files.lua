-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local name = os.tmpname()
local out = assert(io.open(name, "w"))
print(io.type(out), io.type(io.stdout), io.type(42))
print(out:write("first\n", 2, " ", 3.5, "\nlast") == true, out:seek("cur"), out:seek("set", 0))
print(out:close(), io.type(out), pcall(out.write, out, "x"))
for line in io.lines(name) do io.write("[", line, "]") end
print()
local back = io.open(name)
print(back:read("*l"), back:read("*n"), back:read("*n"), back:read(1), back:read("*a"), back:read("*a"), back:read("*l"))
print(back:seek("end"), back:seek("set", 3), back:read(2), back:read(0))
back:close()
local appended = io.open(name, "a"); appended:write("!"); appended:close()
local all = io.open(name):read("*a")
print(#all, all:sub(-1))
print(os.remove(name), io.open(name) == nil, select("#", os.remove(name)))
print(select(2, io.open("/no/such/file")))
print(pcall(io.lines, "/no/such/file"))
