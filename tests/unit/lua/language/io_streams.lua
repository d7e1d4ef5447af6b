-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print(io.read("*l"), io.read(3), io.read("*n"), io.read("*l"), io.read("*a"), io.read("*l"))
io.stderr:write("to stderr\n")
io.stdout:write("to ", "stdout\n")
local p = io.popen("echo piped; exit 3")
print(p:read("*a"), p:close())
print(io.output() == io.stdout, io.input() == io.stdin)
