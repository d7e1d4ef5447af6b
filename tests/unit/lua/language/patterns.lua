-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print(("key = value"):match("^(%w+)%s*=%s*(%w+)$"))
print(("one two  three"):gsub("%w+", string.upper))
print(("hello world"):gsub("o", {o = "0"}), ("abc"):gsub("", "-"), ("abc"):gsub("%w", "%0%0", 2))
print(("$name is $age"):gsub("%$(%w+)", {name = "Lua", age = 5.1}))
print(("f(a(b)c)d"):match("%b()"), ("THE (quick) fox"):find("%((%a+)%)"), ("a.b"):find(".", 1, true))
for k, v in ("a=1, b=2"):gmatch("(%w+)=(%w+)") do io.write(k, "->", v, ";") end
print()
print(("  trim  "):match("^%s*(.-)%s*$") .. "|", ("x"):match("()"), ("THE END"):match("%f[%a]%a+$"))
print(("2024-05-06"):match("(%d+)-(%d+)-(%d+)"), pcall(string.match, "x", "[a"), pcall(string.gsub, "x", "x", "%2"))
