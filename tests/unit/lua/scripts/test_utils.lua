-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- utils and ansicolors.
local check = require("check")
local u = require("utils")

check.equal("ab  ", u.rpad("ab", 4))
check.equal("ab..", u.rpad("ab", 4, "."))
check.equal("abcdef", u.rpad("abcdef", 4))
check.equal("abcd", u.rpad("abcdef", 4, " ", true))
check.equal("  12", u.lpad(12, 4))
check.equal("ab", u.lpad("abc", 2, " ", true))
check.equal("ab", u.strsetlen("abc", 2))
check.equal("abc ", u.strsetlen("abc", 4))
check.equal("a b", u.trim("  a b\n"))
check.equal({ "a", "b", "c" }, u.split("a b\tc"))
check.equal({ "a", "", "b" }, u.split("a,,b", ","))
check.equal({ "abc" }, u.split("abc", ","))
check.equal("aa bb\ncc", u.wrap("aa bb cc", 5))
check.equal("* aa\n  bb", u.wrap("aa  bb", 5, "  ", "* "))
check.equal("", u.wrap("", 5))
check.equal("/a/b", u.dirname("/a/b/c.lua"))
check.equal("c.lua", u.basename("/a/b/c.lua"))
check.equal(".", u.dirname("c.lua"))

check.equal('{1,"a",{2},x=true}', u.tab2str({ 1, "a", { 2 }, x = true }))
check.equal('{["a b"]=1,[10]=2}', (u.tab2str({ ["a b"] = 1, [10] = 2 }):gsub("^{%[10%]=2,(.*)}$", "{%1,[10]=2}")))
check.equal("{}", u.tab2str({}))
check.equal("nil", u.tab2str(nil))
local circle = {}
circle.me = circle
check.equal("{me={...}}", u.tab2str(circle))
check.equal('{1}\t"x"\tnil', check.printed(u.pp, { 1 }, "x", nil))

local deep = { 1, { 2, { 3 } }, x = {} }
local copy = u.deepcopy(deep)
check.equal(deep, copy)
copy[2][2][1] = 4
check.equal(3, deep[2][2][1])
check.yes(u.deepcopy(circle).me.me ~= circle)
check.yes(u.table_cmp(deep, u.deepcopy(deep)))
check.no(u.table_cmp(deep, copy))
check.no(u.table_cmp({}, { 1 }))
check.yes(u.table_has({ 1, 2 }, 2))
check.no(u.table_has({ 1, 2 }, 3))
check.equal({ 3, 1, 2 }, u.table_unique({ 3, 1, 3, 2, 1 }))
check.equal({ 1, "a", "b" }, u.keys({ b = 1, a = 2, 3 }))
check.equal({ 2, 4 }, u.map(function(x) return 2 * x end, { 1, 2 }))
check.equal({ 2 }, u.filter(function(x) return x % 2 == 0 end, { 1, 2, 3 }))
check.equal("abc", u.foldr(function(a, b) return a .. b end, "", { "a", "b", "c" }))
local even = function(x) return x % 2 == 0 end
check.equal({ true, false, true, false },
   { u.andt(even, { 2, 4 }), u.andt(even, { 2, 3 }), u.ort(even, { 1, 2 }), u.ort(even, { 1 }) })
check.equal({ 1, 2, 3, 4 }, u.append({ 1, 2 }, {}, { 3 }, 4))
check.equal({ 1, 2, 3 }, u.flatten({ 1, { 2, { 3 } } }))
check.equal({ [0] = { "x" }, ["-o"] = { "a", "-1" }, ["--all"] = {} },
   u.proc_args({ "x", "-o", "a", "-1", "--all" }))
check.yes(u.file_exists(debug.getinfo(1, "S").source:sub(2)))
check.no(u.file_exists("/no/such/file"))
check.equal(3, u.try("adding", function(a, b) return a + b end, 1, 2))
check.fails("adding: ", u.try, "adding", error, "no")

local written, stdout, stderr = {}, io.stdout, io.stderr
local stream = { write = function(_, ...) for _, one in ipairs({ ... }) do written[#written + 1] = one end end }
io.stdout, io.stderr = stream, stream
u.write("a", 1)
u.stdout("b", 2)
u.stderr("c", nil)
io.stdout, io.stderr = stdout, stderr
check.equal("a1b\t2\nc\tnil\n", table.concat(written))

local a = require("ansicolors")
check.equal("\27[31mx\27[0m", a.red .. "x" .. a.reset)
check.equal("\27[31mx\27[0m", a.red("x"))
check.equal("\27[1m\27[44m", a.bright .. a.onblue)
check.equal("\27[32m", tostring(a.green))

check.equal({ 2, 4 }, u.imap(function(x) return 2 * x end, { 1, 2 }))
local seen = {}
u.foreach(function(value, key) seen[key] = value end, { a = 1, 5 })
check.equal({ 5, a = 1 }, seen)
check.done()
